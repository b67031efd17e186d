// The base class of commands that replace one value of the document.
#pragma once

#include "commands/documentcommand.h"

#include <utility>

namespace autocuts {

//! Replaces one value. A derived class says how the value is set, by set().
template <typename Value>
class ChangeValue : public DocumentCommand
{
public:
    bool hasAnyChanges() const final { return mBefore != mAfter; }

protected:
    ChangeValue(Document &document, Value before, Value after)
        : DocumentCommand(document), mBefore(std::move(before)), mAfter(std::move(after))
    {}

    virtual void set(const Value &value) = 0;
    void apply() final { set(mAfter); }
    void revert() final { set(mBefore); }
    qint64 payloadBytes() const override { return bytesOf(mBefore) + bytesOf(mAfter); }
    void clearPayload() final { mBefore = mAfter = Value(); }

    Value mBefore, mAfter;

private:
    //! Bytes beside the object itself.
    static qint64 bytesOf(const Value &value)
    {
        if constexpr (requires { sizeof(typename Value::value_type); })
            return qint64(value.size()) * qint64(sizeof(typename Value::value_type));
        else
            return 0;
    }
};

} // namespace autocuts
