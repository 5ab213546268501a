# For CMAKE_TOOLCHAIN_FILE where the compiler of shaders is built to be run once: unoptimised it is built in a fraction of the time, and
# compiles the few shaders there are in seconds all the same.
set(CMAKE_C_FLAGS_RELEASE "-O0 -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O0 -DNDEBUG" CACHE STRING "")
set(SHADERC_SKIP_EXAMPLES ON CACHE BOOL "")
set(SHADERC_SKIP_EXECUTABLES ON CACHE BOOL "")
