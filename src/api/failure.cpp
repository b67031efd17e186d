#include "api/failure.h"

namespace autocuts::api {

namespace {

void copyText(const std::string &text, char *out, std::size_t room)
{
    const std::size_t length = text.copy(out, room - 1);
    out[length] = 0;
}

} // namespace

autocuts_status give(const Failure &failure, autocuts_error *error)
{
    if (error) {
        copyText(failure.message, error->message, sizeof error->message);
        copyText(failure.remedy, error->remedy, sizeof error->remedy);
    }
    return failure.status;
}

} // namespace autocuts::api
