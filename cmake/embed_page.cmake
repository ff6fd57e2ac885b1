# Writes a C++ source that holds the report's script and style sheet, with their SHA-256 for the policy
# that lets nothing else run.
# usage: cmake -DSCRIPT=report.js -DSTYLE=report.css -DOUT=page_bundle.cpp -P embed_page.cmake

set(letters "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")

# Three bytes make four letters; a SHA-256 is ten times three bytes and two.
function(base64_of_sha256 hex result)
  set(text "")
  foreach(start RANGE 0 54 6)
    string(SUBSTRING ${hex} ${start} 6 part)
    foreach(shift 18 12 6 0)
      math(EXPR letter "(0x${part} >> ${shift}) & 63")
      string(SUBSTRING ${letters} ${letter} 1 letter)
      string(APPEND text ${letter})
    endforeach()
  endforeach()
  string(SUBSTRING ${hex} 60 4 part)
  foreach(shift 10 4)
    math(EXPR letter "(0x${part} >> ${shift}) & 63")
    string(SUBSTRING ${letters} ${letter} 1 letter)
    string(APPEND text ${letter})
  endforeach()
  math(EXPR letter "(0x${part} << 2) & 63")
  string(SUBSTRING ${letters} ${letter} 1 letter)
  set(${result} "${text}${letter}=" PARENT_SCOPE)
endfunction()

# Browsers turn CR into LF before they compute the hash, and take these marks for the end.
function(refuse_what_html_changes file bytes)
  foreach(mark "\r" "</script" "</style" "<!--")
    string(HEX "${mark}" hex)
    string(REGEX REPLACE "(..)" "\\\\x\\1" escaped "${hex}")
    string(FIND "${bytes}" "${escaped}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file}: holds the bytes ${hex}, which HTML does not leave alone")
    endif()
  endforeach()
endfunction()

set(source "// Made by cmake/embed_page.cmake.\n#include \"evenmesh/report/page_bundle.h\"\n\nnamespace evenmesh {\nnamespace {\n\n")
foreach(name SCRIPT STYLE)
  file(READ ${${name}} hex HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  refuse_what_html_changes(${${name}} "${bytes}")
  string(APPEND source "constexpr char k${name}[] = \"${bytes}\";\n")
  file(SHA256 ${${name}} digest)
  base64_of_sha256(${digest} sha256_of_${name})
endforeach()
string(APPEND source "
}  // namespace

const PageBundle& page_bundle() {
  static constexpr PageBundle kBundle{{kSCRIPT, sizeof kSCRIPT - 1},
                                      {kSTYLE, sizeof kSTYLE - 1},
                                      \"${sha256_of_SCRIPT}\",
                                      \"${sha256_of_STYLE}\"};
  return kBundle;
}

}  // namespace evenmesh
")
file(WRITE ${OUT} "${source}")
