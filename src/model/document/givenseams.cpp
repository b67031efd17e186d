#include "model/document/givenseams.h"

#include "model/plain/givenseams.h"

namespace autocuts {

std::vector<bool> givenSeams(const Scene &scene, const UvMatrix *uv, std::span<const PairState> states,
                             const GivenSeamOptions &options)
{
    return givenSeams({*scene.mesh, uv, states, scene.hardEdges, scene.faceMaterial}, options);
}

bool changesGivenSeams(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Model:
    case ChangeEvent::Type::Uv:
    case ChangeEvent::Type::UvSet:
        return true;
    case ChangeEvent::Type::Seam:
        return (static_cast<const SeamEvent &>(event).properties & SeamEvent::State) != 0;
    case ChangeEvent::Type::SolveSettings:
        return (static_cast<const SolveSettingsEvent &>(event).properties &
                (SeamModeProperty | SeamSourcesProperty | SharpAngleProperty)) != 0;
    case ChangeEvent::Type::Pin:
    case ChangeEvent::Type::Rectangle:
    case ChangeEvent::Type::IslandFlag:
    case ChangeEvent::Type::Tag:
    case ChangeEvent::Type::Hidden:
    case ChangeEvent::Type::Textures:
    case ChangeEvent::Type::SharedMeshes:
    case ChangeEvent::Type::PackingSettings:
    case ChangeEvent::Type::TexelWeight:
        return false;
    }
    return false;
}

} // namespace autocuts
