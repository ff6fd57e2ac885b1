(function () {
  "use strict";
  var report = JSON.parse(document.getElementById("evenmesh-report").textContent);
  document.title = "evenmesh: " + report.title;
})();
