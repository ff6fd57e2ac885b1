#include "evenmesh/base/missing.h"
#include <CLI/CLI.hpp>
#include <evenmesh/base/wrong.h>
#include <iostream>

void wrong() {
  std::cout << "exit(";  // and abort() in a comment is no call
  std::printf("no");
  exit(1);
}
