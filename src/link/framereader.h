// Cuts what comes over the live link into messages.
#pragma once

#include "link/message.h"

#include <optional>

namespace autocuts::link {

//! What a frame may have at most, in bytes. Chosen by hand: a model of 20 million triangles fits.
struct FrameLimits
{
    qint64 fields = qint64(4) << 20;
    qint64 arrays = qint64(1) << 30;

    //! Of a program that has not shown the token yet.
    static constexpr FrameLimits ofStrangers() { return {4096, 0}; }
};

//! Collects bytes until they make a frame. Keeps no more bytes than it was given.
class FrameReader
{
public:
    void setLimits(const FrameLimits &limits) { mLimits = limits; }
    void feed(const QByteArray &bytes) { mBytes += bytes; }
    //! The next message; nothing while its bytes are not all there. An Error when the bytes are no frame:
    //! nothing that follows can be read then.
    Result<std::optional<Message>> next();

private:
    FrameLimits mLimits;
    QByteArray mBytes;
};

} // namespace autocuts::link
