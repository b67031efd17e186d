#include "views/panels/texturenaming.h"

#include <QCoreApplication>

namespace autocuts {

namespace {

struct ChannelTexts
{
    Q_DECLARE_TR_FUNCTIONS(TextureChannels)
};

} // namespace

QString channelName(TextureChannel channel)
{
    switch (channel) {
    case TextureChannel::BaseColor:
        return ChannelTexts::tr("Base colour");
    case TextureChannel::Roughness:
        return ChannelTexts::tr("Roughness");
    case TextureChannel::Metalness:
        return ChannelTexts::tr("Metalness");
    case TextureChannel::Normal:
        return ChannelTexts::tr("Normal");
    case TextureChannel::Occlusion:
        return ChannelTexts::tr("Occlusion");
    case TextureChannel::Emission:
        return ChannelTexts::tr("Emission");
    case TextureChannel::Height:
        break;
    }
    return ChannelTexts::tr("Height");
}

} // namespace autocuts
