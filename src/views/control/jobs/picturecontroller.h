// Starts the jobs that make pictures: bakes, light, carried textures.
#pragma once

#include <QObject>

#include <functional>

class QImage;

namespace autocuts {

class MapController;
class SolverController;
class Workspace;
namespace jobs {
struct BakeChoice;
struct CarryChoice;
struct LightChoice;
} // namespace jobs

//! Starts jobs of MapController that write pictures and may give them to the materials. The map stays as it
//! is.
class PictureController final : public QObject
{
    Q_OBJECT

public:
    //! Receives the picture of a tile, from coarse to fine, on any thread.
    using TileReceiver = std::function<void(int tile, const QImage &picture)>;

    PictureController(Workspace &workspace, SolverController &solver, MapController &map,
                      QObject *parent = nullptr);

    //! Bakes pictures for the map and writes them.
    void bake(const jobs::BakeChoice &choice);
    //! Makes the textures of the materials new for the map, as files, and gives them to the materials.
    void carryTextures(const jobs::CarryChoice &choice);
    //! Bakes light into a UV set, which becomes the active one; where the choice wants a new one, it is made
    //! before.
    void bakeLight(const jobs::LightChoice &choice, const TileReceiver &shown);

private:
    void startLightBake(const jobs::LightChoice &choice, const TileReceiver &shown, bool other);

    Workspace &mWorkspace;
    SolverController &mSolver;
    MapController &mMap;
};

} // namespace autocuts
