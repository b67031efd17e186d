// How a call of the library ends: nothing is thrown at the caller.
#pragma once

#include <autocuts/autocuts.h>

#include <new>
#include <stdexcept>
#include <string>

namespace autocuts::api {

//! Ends a call with a status and the texts for the caller.
struct Failure
{
    autocuts_status status = AUTOCUTS_OK;
    std::string message{}, remedy{};
};

inline Failure badInput(const std::string &message, const std::string &remedy = {})
{
    return {AUTOCUTS_BAD_INPUT, message, remedy};
}

inline Failure noRoom()
{
    return {AUTOCUTS_NO_ROOM, "there is no room for the margins between the islands",
            "Use a smaller margin or a larger texture"};
}

//! Hands a failure to the caller. \param error may be null
autocuts_status give(const Failure &failure, autocuts_error *error);

//! Runs a call and turns what it throws into a status. \param error may be null
template <class Work>
autocuts_status guarded(autocuts_error *error, Work work)
{
    try {
        work();
        return give({}, error);
    } catch (const Failure &known) {
        return give(known, error);
    } catch (const std::bad_alloc &) {
        return give({AUTOCUTS_NO_MEMORY, "not enough memory", "Use a smaller mesh"}, error);
    } catch (const std::invalid_argument &bad) {
        return give(badInput(bad.what()), error);
    } catch (const std::exception &fault) {
        return give({AUTOCUTS_FAILED, fault.what()}, error);
    }
}

} // namespace autocuts::api
