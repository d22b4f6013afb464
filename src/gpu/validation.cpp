#include "gpu/validation.h"

#include <spdlog/spdlog.h>

#include <mutex>

namespace tetralux::gpu {
namespace {

std::mutex messagesMutex;
std::vector<std::string>& messages() {
  static std::vector<std::string> list;
  return list;
}

VKAPI_ATTR VkBool32 VKAPI_CALL receive(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
  const std::lock_guard lock(messagesMutex);
  messages().emplace_back(data->pMessage);
  spdlog::error("validation: {}", data->pMessage);
  return VK_FALSE;
}

}  // namespace

std::vector<std::string> takeValidationMessages() {
  const std::lock_guard lock(messagesMutex);
  return std::exchange(messages(), {});
}

VkDebugUtilsMessengerCreateInfoEXT validationMessenger() {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = receive;
  return info;
}

}  // namespace tetralux::gpu
