// Where messages of the validation layers go.
#pragma once

#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace tetralux::gpu {

// Messages (warnings and errors) since the program started or since the last call, in order; then forgets them.
// Every message is also logged when it arrives. May be called from any thread.
std::vector<std::string> takeValidationMessages();

// What an instance needs to send its messages here.
VkDebugUtilsMessengerCreateInfoEXT validationMessenger();

}  // namespace tetralux::gpu
