// Autocuts for C++: UV maps of polygon meshes. Wraps autocuts.h, which says units and conventions; nothing
// but the standard library and that header is needed. Functions throw Error.
#ifndef AUTOCUTS_HPP
#define AUTOCUTS_HPP

#include <autocuts/autocuts.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace autocuts {

//! What went wrong; what() has the problem and the remedy.
class Error : public std::runtime_error
{
public:
    Error(autocuts_status status, const autocuts_error &error)
        : std::runtime_error(error.remedy[0] ? std::string(error.message) + ". " + error.remedy
                                             : error.message),
          mStatus(status), mRemedy(error.remedy)
    {}
    autocuts_status status() const { return mStatus; }
    const std::string &remedy() const { return mRemedy; }

private:
    autocuts_status mStatus;
    std::string mRemedy;
};

//! A corner that is held at a place in the map.
using Pin = autocuts_pin;

//! A view of a mesh; the arrays must live as long as it is used. Empty spans are left out. autocuts_mesh says
//! what each holds.
struct Mesh
{
    std::span<const double> positions;             //!< x, y, z of each vertex
    std::span<const std::uint32_t> indices;        //!< the vertex of each corner
    std::span<const std::uint32_t> faceSizes = {}; //!< empty: triangles
    std::span<const std::int32_t> faceObjects = {};
    std::span<const double> uvs = {}; //!< u, v of each corner
    std::span<const std::uint8_t> lockedFaces = {};
    std::span<const std::uint8_t> edges = {}; //!< autocuts_edge of each corner
    std::span<const std::int32_t> faceMaterials = {};
    std::span<const double> normals = {};      //!< x, y, z of each corner
    std::span<const double> colors = {};       //!< red, green, blue of each corner, linear
    std::span<const double> edgeWeights = {};  //!< per corner
    std::span<const double> texelWeights = {}; //!< per face
    std::span<const Pin> pins = {};
};

//! Receives a share from 0 to 1; returns false to stop with the best map so far.
using Progress = std::function<bool(double fraction)>;

//! The defaults are those of autocuts-cli.
struct Options : autocuts_options
{
    Options() { autocuts_options_init(this); }
};

//! The defaults are those of autocuts-cli.
struct BakeOptions : autocuts_bake_options
{
    BakeOptions() { autocuts_bake_options_init(this); }
};

using Figures = autocuts_figures;
using Outcome = autocuts_outcome;
using Transferred = autocuts_transferred;

namespace detail {

//! Throws what a call of the C interface says.
template <class Call>
void check(Call call)
{
    autocuts_error error{};
    if (const autocuts_status status = call(&error); status != AUTOCUTS_OK)
        throw Error(status, error);
}

} // namespace detail

//! A map; what it gives out lives as long as it does.
class Map
{
public:
    explicit Map(autocuts_map *map) : mMap(map, autocuts_map_free) {}
    //! u, v of each corner.
    std::span<const double> uvs() const { return {autocuts_map_uvs(mMap.get()), 2 * corners()}; }
    //! The island of each face, from 0; -1 without UVs.
    std::span<const std::int32_t> islands() const
    {
        return {autocuts_map_islands(mMap.get()), autocuts_map_face_count(mMap.get())};
    }
    //! Per corner: 1 when the edge to the next corner of its face is a seam or a border.
    std::span<const std::uint8_t> seams() const { return {autocuts_map_seams(mMap.get()), corners()}; }
    std::size_t islandCount() const { return autocuts_map_island_count(mMap.get()); }
    Outcome outcome() const { return autocuts_map_outcome(mMap.get()); }
    bool stopped() const { return outcome().stopped != 0; }
    Figures measure() const
    {
        Figures figures{};
        detail::check([&](autocuts_error *error) { return autocuts_measure(mMap.get(), &figures, error); });
        return figures;
    }
    //! A picture of height x width x 4 bytes, rows from the top, see autocuts_draw().
    std::vector<std::uint8_t> draw(int width, int height, int tile = 1001) const
    {
        const bool fits = width > 0 && height > 0 && width <= 65536 && height <= 65536;
        std::vector<std::uint8_t> rgba(fits ? 4 * std::size_t(width) * std::size_t(height) : 0);
        detail::check([&](autocuts_error *error) {
            return autocuts_draw(mMap.get(), tile, width, height, rgba.data(), error);
        });
        return rgba;
    }

private:
    std::size_t corners() const { return autocuts_map_corner_count(mMap.get()); }
    std::unique_ptr<autocuts_map, void (*)(autocuts_map *)> mMap;
};

namespace detail {

inline autocuts_mesh viewOf(const Mesh &mesh)
{
    const auto fail = [](const char *message) {
        autocuts_error error{};
        std::string(message).copy(error.message, sizeof error.message - 1);
        throw Error(AUTOCUTS_BAD_INPUT, error);
    };
    std::size_t faces = mesh.faceSizes.size(), corners = 0;
    for (const std::uint32_t size : mesh.faceSizes)
        corners += size;
    if (mesh.faceSizes.empty()) {
        faces = mesh.indices.size() / 3;
        corners = 3 * faces;
    }
    if (mesh.positions.size() % 3 != 0)
        fail("positions have three numbers per vertex");
    if (mesh.indices.size() != corners)
        fail("there are not as many indices as the faces have corners");
    if (!mesh.faceObjects.empty() && mesh.faceObjects.size() != faces)
        fail("there is not one object per face");
    if (!mesh.uvs.empty() && mesh.uvs.size() != 2 * corners)
        fail("there are not two UV numbers per corner");
    if (!mesh.lockedFaces.empty() && mesh.lockedFaces.size() != faces)
        fail("there is not one lock per face");
    if (!mesh.edges.empty() && mesh.edges.size() != corners)
        fail("there is not one edge per corner");
    const auto perCorner = [&](std::size_t size, std::size_t each, const char *message) {
        if (size != 0 && size != each * corners)
            fail(message);
    };
    perCorner(mesh.normals.size(), 3, "there are not three numbers of a normal per corner");
    perCorner(mesh.colors.size(), 3, "there are not three numbers of a colour per corner");
    perCorner(mesh.edgeWeights.size(), 1, "there is not one edge weight per corner");
    if (!mesh.faceMaterials.empty() && mesh.faceMaterials.size() != faces)
        fail("there is not one material per face");
    if (!mesh.texelWeights.empty() && mesh.texelWeights.size() != faces)
        fail("there is not one texel weight per face");
    const auto orNull = [](const auto &span) { return span.empty() ? nullptr : span.data(); };
    autocuts_mesh view{};
    view.positions = mesh.positions.data();
    view.vertex_count = mesh.positions.size() / 3;
    view.face_sizes = orNull(mesh.faceSizes);
    view.face_count = faces;
    view.indices = mesh.indices.data();
    view.face_objects = orNull(mesh.faceObjects);
    view.uvs = orNull(mesh.uvs);
    view.locked_faces = orNull(mesh.lockedFaces);
    view.edges = orNull(mesh.edges);
    view.face_materials = orNull(mesh.faceMaterials);
    view.normals = orNull(mesh.normals);
    view.colors = orNull(mesh.colors);
    view.edge_weights = orNull(mesh.edgeWeights);
    view.texel_weights = orNull(mesh.texelWeights);
    view.pins = orNull(mesh.pins);
    view.pin_count = mesh.pins.size();
    return view;
}

//! Lets a function of C++ receive progress. \param options of a map or of a bake
template <class Options>
void listen(const Progress &progress, Options &options)
{
    if (!progress)
        return;
    options.user = const_cast<Progress *>(&progress);
    options.progress = [](double fraction, void *user) {
        return (*static_cast<const Progress *>(user))(fraction) ? 0 : 1;
    };
}

template <class Call>
Map run(Call call, const Mesh &mesh, Options options, const Progress &progress)
{
    listen(progress, options);
    const autocuts_mesh view = viewOf(mesh);
    autocuts_map *map = nullptr;
    check([&](autocuts_error *error) { return call(&view, &options, &map, error); });
    return Map(map);
}

} // namespace detail

//! Receives each better map of a search, on another thread; must not throw. See autocuts_options.better.
using TakeMap = std::function<void(Map map)>;

//! Cuts, maps and packs.
inline Map unwrap(const Mesh &mesh, Options options = {}, const Progress &progress = {},
                  const TakeMap &better = {})
{
    if (better) {
        options.better_user = const_cast<TakeMap *>(&better);
        options.better = [](autocuts_map *map, void *user) {
            (*static_cast<const TakeMap *>(user))(Map(map));
        };
    }
    return detail::run(autocuts_unwrap, mesh, options, progress);
}
//! Packs the islands of mesh.uvs.
inline Map pack(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_pack, mesh, options, progress);
}
//! Cuts the islands of mesh.uvs that overlap themselves, and packs.
inline Map separate(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_separate, mesh, options, progress);
}
//! Makes the map mesh.uvs usable.
inline Map finish(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_finish, mesh, options, progress);
}
//! Turns the islands of mesh.uvs to the axes and makes straight what is straight on the mesh.
inline Map align(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_align, mesh, options, progress);
}
//! Makes a map for light maps of mesh.uvs.
inline Map lightmap(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_lightmap, mesh, options, progress);
}
//! mesh.uvs as a map, to be measured or drawn.
inline Map take(const Mesh &mesh, const Options &options = {})
{
    return detail::run(autocuts_take, mesh, options, {});
}
//! Gives the mesh the UVs of another one. \param figures says how well they were matched; may be null
inline Map transfer(const Mesh &source, const Mesh &mesh, autocuts_match match = AUTOCUTS_MATCH_AUTO,
                    const Options &options = {}, Transferred *figures = nullptr,
                    const Progress &progress = {})
{
    const autocuts_mesh from = detail::viewOf(source);
    return detail::run(
        [&](const autocuts_mesh *view, const autocuts_options *own, autocuts_map **map,
            autocuts_error *error) {
            return autocuts_transfer(&from, view, match, own, map, figures, error);
        },
        mesh, options, progress);
}

//! A map that gets better all the time on a thread of its own, and follows its steering.
class LiveSolve
{
public:
    explicit LiveSolve(const Mesh &mesh, const Options &options = {}) : mLive(nullptr, autocuts_live_free)
    {
        const autocuts_mesh view = detail::viewOf(mesh);
        autocuts_live *live = nullptr;
        detail::check(
            [&](autocuts_error *error) { return autocuts_live_start(&view, &options, &live, error); });
        mLive.reset(live);
    }
    //! Takes other pins, edges, weights, locks or options for the same faces.
    void steer(const Mesh &mesh, const Options &options = {})
    {
        const autocuts_mesh view = detail::viewOf(mesh);
        detail::check(
            [&](autocuts_error *error) { return autocuts_live_steer(mLive.get(), &view, &options, error); });
    }
    //! Waits for a map that was not given out yet; nothing when none came in time, or when nothing is left to
    //! gain.
    std::optional<Map> wait(double seconds)
    {
        autocuts_map *map = nullptr;
        detail::check(
            [&](autocuts_error *error) { return autocuts_live_wait(mLive.get(), seconds, &map, error); });
        return map ? std::optional<Map>(map) : std::nullopt;
    }
    bool rests() const { return autocuts_live_rests(mLive.get()) != 0; }

private:
    std::unique_ptr<autocuts_live, void (*)(autocuts_live *)> mLive;
};

//! Pictures of a bake, one for each map that was asked for: height x width x autocuts_bake_channels().
struct Bake
{
    std::vector<std::vector<float>> pictures;
    autocuts_baked figures{};
};

//! Bakes into the map mesh.uvs. \param high the detailed mesh; null: the mesh itself
inline Bake bake(const Mesh &mesh, const Mesh *high, std::span<const int> maps, BakeOptions options = {},
                 const Progress &progress = {})
{
    detail::listen(progress, options);
    const autocuts_mesh view = detail::viewOf(mesh);
    const autocuts_mesh detailed = high ? detail::viewOf(*high) : autocuts_mesh{};
    const bool fits =
        options.width > 0 && options.height > 0 && options.width <= 65536 && options.height <= 65536;
    const std::size_t texels = fits ? std::size_t(options.width) * std::size_t(options.height) : 0;
    Bake made;
    std::vector<float *> places;
    for (const int map : maps) {
        made.pictures.emplace_back(texels * std::size_t(autocuts_bake_channels(map)));
        places.push_back(made.pictures.back().data());
    }
    detail::check([&](autocuts_error *error) {
        return autocuts_bake(&view, high ? &detailed : nullptr, &options, maps.data(), maps.size(),
                             places.data(), &made.figures, error);
    });
    return made;
}

} // namespace autocuts

#endif
