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
    return std::make_unique<SetUvs>(document, edit, uv, extras);
}

} // namespace autocuts
