#pragma once

#include <functional>

namespace rt::lang {

/// Runs `body` on a far larger stack than a thread's own, so that the limit on nested calls is reached before the end
/// of the stack. `body` gets the lowest address that its calls may reach; what is below is reserved for the innermost
/// of them. Exceptions pass through. If there is no memory for the stack, the caller's own is used.
void run_on_deep_stack(const std::function<void(const char* stack_limit)>& body);

} // namespace rt::lang
