#pragma once

#include <stdexcept>
#include <string>

namespace rt::tools::lsp {

/// The protocol's error codes (JSON-RPC 2.0, section 5.1; LSP 3.17, "ErrorCodes").
enum class ErrorCode : int {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  server_not_initialized = -32002,
  request_failed = -32803,
  request_cancelled = -32800,
};

/// Why a request has no result.
struct RequestError : std::runtime_error {
  RequestError(ErrorCode its_code, const std::string& message) : runtime_error(message), code(its_code) {}
  ErrorCode code;
};

} // namespace rt::tools::lsp
