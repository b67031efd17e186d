#include "link/framereader.h"

#include <QtEndian>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype spareBytes = 4 << 20; // that a reader keeps; chosen by hand

} // namespace

Result<std::optional<Message>> FrameReader::next()
{
    if (mBytes.size() < frameHeadSize)
        return std::optional<Message>();
    const qsizetype fields = qFromLittleEndian<quint32>(mBytes.constData());
    const qsizetype arrays = qFromLittleEndian<quint32>(mBytes.constData() + 4);
    if (fields > mLimits.fields || arrays > mLimits.arrays)
        return linkError(u"a message is larger than allowed"_s);
    const qsizetype end = frameHeadSize + fields + arrays;
    if (mBytes.size() < end)
        return std::optional<Message>();
    Result<Message> message =
        Message::decode(mBytes.sliced(frameHeadSize, fields), mBytes.sliced(frameHeadSize + fields, arrays));
    mBytes.remove(0, end);
    if (mBytes.capacity() - mBytes.size() > spareBytes)
        mBytes.squeeze(); // gives the memory of a large message back
    if (!message)
        return message.error();
    return std::optional(std::move(message).value());
}

} // namespace autocuts::link
