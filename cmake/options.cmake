# Flags for evenmesh's own targets only; nothing here reaches a project that links the library.
add_library(evenmesh_build_options INTERFACE)
target_compile_options(evenmesh_build_options INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  # A fused multiply-add rounds once where two operations round twice, and whether the compiler
  # fuses depends on the target. Same bits everywhere is a promise, so it may not.
  -ffp-contract=off
  # sqrt() need not set errno; without this it cannot be vectorised.
  -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 and 13 see overlapping copies in every std::string concatenation (GCC bug 105651).
  target_compile_options(evenmesh_build_options INTERFACE -Wno-restrict)
endif()
if(EVENMESH_WARNINGS_AS_ERRORS)
  target_compile_options(evenmesh_build_options INTERFACE -Werror)
endif()
if(EVENMESH_SANITIZE)
  target_compile_options(evenmesh_build_options INTERFACE
    -fsanitize=${EVENMESH_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(evenmesh_build_options INTERFACE -fsanitize=${EVENMESH_SANITIZE})
endif()
