#include "commands/newmap.h"

#include "model/plain/uvlayout.h"

namespace autocuts {

std::unique_ptr<SetUvs> newMapCommand(Document &document, UvEdit edit, const UvMatrix &uv,
                                      std::optional<int> count)
{
    UvEditExtras extras;
    extras.count = count ? *count : Islands(document.mesh(), uv).count();
    if (sameBits(uv, document.uv()))
        return std::make_unique<SetUvs>(document, edit, uv, extras);
    extras.scale = layoutScale(document.mesh(), uv);
    for (UvPin pin : document.constraints().pins) {
        if (!uv.row(pin.corner).allFinite())
            continue;
        pin.position = uv.row(pin.corner);
        extras.pins.push_back(pin);
    }
    return std::make_unique<SetUvs>(document, edit, uv, extras);
}

} // namespace autocuts
