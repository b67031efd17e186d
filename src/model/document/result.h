// Result<T>: what file functions return instead of throwing.
#pragma once

#include <QString>

#include <utility>
#include <variant>

namespace autocuts {

//! The message of a failure, where it happened, and what the user can do about it.
struct Error
{
    QString message; //!< the problem, one line, no full stop at the end
    QString file;    //!< path of the file; empty when there is none
    int line = 0;    //!< 1-based line in that file, 0 when unknown
    QString remedy;  //!< what to do, one line; may be empty

    //! "FILE:LINE: MESSAGE. REMEDY." on one line, for a terminal or a message box.
    QString toString() const;
};

//! Either a value or an Error.
template <typename T>
class [[nodiscard]] Result
{
public:
    Result(T value) : mContent(std::move(value)) {}
    Result(Error error) : mContent(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(mContent); }
    explicit operator bool() const { return ok(); }

    //! \pre ok()
    T &value() & { return std::get<T>(mContent); }
    const T &value() const & { return std::get<T>(mContent); }
    T &&value() && { return std::get<T>(std::move(mContent)); }
    T *operator->() { return &std::get<T>(mContent); }
    const T *operator->() const { return &std::get<T>(mContent); }
    //! \pre !ok()
    const Error &error() const { return std::get<Error>(mContent); }

private:
    std::variant<T, Error> mContent;
};

//! The value of a Result that returns nothing on success.
struct Done
{};

} // namespace autocuts
