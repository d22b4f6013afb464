// The one place that holds volk's function pointers.
#define VOLK_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <volk.h>
#pragma GCC diagnostic pop
