#pragma once

#include <functional>

namespace rt::lang {

/// Runs `body` with far more stack than a thread has of itself, so that the limit on nested calls is reached before the
/// end of the stack is. It is given the lowest address that its calls may reach; what lies below is for the last of
/// them. Exceptions pass through. Where there is no memory for the stack, the caller's own serves.
void run_on_deep_stack(const std::function<void(const char* stack_limit)>& body);

} // namespace rt::lang
