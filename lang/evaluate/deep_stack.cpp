#include "lang/evaluate/deep_stack.hpp"

#include <pthread.h>

#include <algorithm>
#include <cstddef>
#include <exception>

namespace rt::lang {
namespace {

constexpr std::size_t stack_size = std::size_t{512} << 20; // of address space: memory is committed as it is used
constexpr std::size_t reserve = std::size_t{6} << 20;      // for the deepest expression within the last call

const char* stack_limit() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
  void* lowest = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return static_cast<const char*>(lowest) + std::min(reserve, size / 2);
}

struct Job {
  const std::function<void(const char*)>& body;
  std::exception_ptr failure;
};

void* start(void* argument) {
  Job& job = *static_cast<Job*>(argument);
  try {
    job.body(stack_limit());
  } catch (...) {
    job.failure = std::current_exception();
  }
  return nullptr;
}

} // namespace

void run_on_deep_stack(const std::function<void(const char*)>& body) {
  Job job{body, nullptr};
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  const bool is_started =
      pthread_attr_setstacksize(&attributes, stack_size) == 0 && pthread_create(&thread, &attributes, start, &job) == 0;
  pthread_attr_destroy(&attributes);
  if (is_started)
    pthread_join(thread, nullptr);
  else
    start(&job);
  if (job.failure) std::rethrow_exception(job.failure);
}

} // namespace rt::lang
