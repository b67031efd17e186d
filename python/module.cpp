// The binding between NumPy and the library. What is checked here are shapes; the rest is checked by the
// library.
#include <autocuts/autocuts.hpp>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace py = pybind11;

namespace {

// Arrays of these types are taken as they are, others are converted.
constexpr int converted = py::array::c_style | py::array::forcecast;
using Doubles = py::array_t<double, converted>;
using Indices = py::array_t<std::uint32_t, converted>;
using Signed = py::array_t<std::int64_t, converted>;
using Ints = py::array_t<std::int32_t, converted>;
using Bytes = py::array_t<std::uint8_t, converted>;
using Floats = py::array_t<float, converted>;
using Callback = std::optional<std::function<bool(double)>>;
using MapPointer = std::shared_ptr<autocuts::Map>;
using MapCallback = std::optional<std::function<void(MapPointer)>>;

template <class Array>
auto spanOf(const Array &array)
{
    return std::span(array.data(), std::size_t(array.size()));
}

[[noreturn]] void refuse(const std::string &message)
{
    throw py::value_error(message);
}

//! The arrays of a mesh, kept alive while a job runs.
struct Arrays
{
    Doubles positions, uvs, normals, colors, edgeWeights, texelWeights;
    Indices indices, sizes;
    Ints objects, materials;
    Bytes locked, edges;
    std::vector<autocuts::Pin> pins;

    autocuts::Mesh view() const
    {
        return {spanOf(positions),
                spanOf(indices),
                spanOf(sizes),
                spanOf(objects),
                spanOf(uvs),
                spanOf(locked),
                spanOf(edges),
                spanOf(materials),
                spanOf(normals),
                spanOf(colors),
                spanOf(edgeWeights),
                spanOf(texelWeights),
                pins};
    }
};

//! Takes positions and faces. \param faces a row for each face, or with sizes the vertices of all corners
void takeFaces(const Doubles &positions, const Signed &faces, const std::optional<Signed> &sizes,
               Arrays &mesh)
{
    if (positions.ndim() != 2 || positions.shape(1) != 3)
        refuse("positions must be an Nx3 array");
    if (sizes ? faces.ndim() != 1 : faces.ndim() != 2 || faces.shape(1) < 3)
        refuse(sizes ? "with face_sizes, faces must be a flat array of the vertices of all corners"
                     : "faces must be an Fx3 array of vertices, or Fx4 and so on");
    mesh.positions = positions;
    mesh.indices = Indices(faces.size());
    for (py::ssize_t i = 0; i < faces.size(); ++i) {
        const std::int64_t vertex = faces.data()[i];
        if (vertex < 0 || vertex >= positions.shape(0))
            refuse("entry " + std::to_string(i) + " of faces is " + std::to_string(vertex) +
                   ", out of range: there are " + std::to_string(positions.shape(0)) + " vertices");
        mesh.indices.mutable_data()[i] = std::uint32_t(vertex);
    }
    if (sizes) {
        mesh.sizes = Indices(*sizes);
    } else if (faces.shape(1) != 3) {
        mesh.sizes = Indices(faces.shape(0));
        std::fill_n(mesh.sizes.mutable_data(), faces.shape(0), std::uint32_t(faces.shape(1)));
    }
}

//! Takes a row of numbers for each corner.
void takePerCorner(const std::optional<Doubles> &given, py::ssize_t columns, const char *name, Doubles &array,
                   const Arrays &mesh)
{
    if (!given)
        return;
    if (given->size() != columns * mesh.indices.size())
        refuse(std::string(name) + " must have " + std::to_string(columns) +
               " numbers per corner: the shape of faces, and " + std::to_string(columns));
    array = *given;
}

//! Pins are rows of corner, u, v and weight; a weight of 0 holds the corner exactly.
void takePins(const std::optional<Doubles> &given, Arrays &mesh)
{
    if (!given || given->size() == 0)
        return;
    if (given->ndim() != 2 || (given->shape(1) != 3 && given->shape(1) != 4))
        refuse("pins must be rows of corner, u, v, or of corner, u, v, weight");
    for (py::ssize_t i = 0; i < given->shape(0); ++i) {
        const double corner = given->at(i, 0);
        if (!(corner >= 0 && corner < double(mesh.indices.size())))
            refuse("pin " + std::to_string(i) + " is at a corner that is out of range: there are " +
                   std::to_string(mesh.indices.size()) + " corners");
        mesh.pins.push_back({static_cast<std::size_t>(corner), given->at(i, 1), given->at(i, 2),
                             given->shape(1) == 4 ? given->at(i, 3) : 0});
    }
}

Arrays arraysOf(const Doubles &positions, const Signed &faces, const std::optional<Signed> &faceSizes,
                const std::optional<Doubles> &uvs, const std::optional<Ints> &objects,
                const std::optional<Ints> &materials, const std::optional<Doubles> &normals,
                const std::optional<Doubles> &colors, const std::optional<Bytes> &locked,
                const std::optional<Bytes> &edges, const std::optional<Doubles> &edgeWeights,
                const std::optional<Doubles> &texelWeights, const std::optional<Doubles> &pins)
{
    Arrays mesh;
    takeFaces(positions, faces, faceSizes, mesh);
    takePerCorner(uvs, 2, "uvs", mesh.uvs, mesh);
    takePerCorner(normals, 3, "normals", mesh.normals, mesh);
    takePerCorner(colors, 3, "colors", mesh.colors, mesh);
    takePerCorner(edgeWeights, 1, "edge_weights", mesh.edgeWeights, mesh);
    mesh.texelWeights = texelWeights.value_or(Doubles());
    mesh.objects = objects.value_or(Ints());
    mesh.materials = materials.value_or(Ints());
    mesh.locked = locked.value_or(Bytes());
    mesh.edges = edges.value_or(Bytes());
    takePins(pins, mesh);
    return mesh;
}

template <class T>
py::array arrayOf(std::span<const T> values, std::vector<py::ssize_t> shape, const py::object &owner)
{
    py::array array(py::dtype::of<T>(), std::move(shape), values.data(), owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

//! A job on a thread of its own, which runs no Python. It is made, used and ended with the interpreter's
//! lock.
template <class Result>
class Background
{
public:
    //! Gets the progress function of the job, and the one that takes better maps.
    using Work = std::function<Result(const autocuts::Progress &, const autocuts::TakeMap &)>;

    //! \param stopped from the start: what needs no time is done \param work must refer to no Python objects
    Background(bool stopped, Work work) : mStop(stopped)
    {
        std::packaged_task<Result()> task([this, work = std::move(work)] {
            return work(
                [this](double fraction) {
                    mShare = fraction;
                    return !mStop;
                },
                [this](autocuts::Map map) {
                    const std::scoped_lock lock(mMutex);
                    mNewest = std::make_shared<autocuts::Map>(std::move(map));
                });
        });
        mMade = task.get_future().share();
        mThread = std::thread(std::move(task));
    }
    ~Background()
    {
        mStop = true;
        const py::gil_scoped_release unlocked;
        mThread.join();
    }
    double share() const { return mShare; }
    void stop() { mStop = true; }
    //! The best map so far that was given out; null before there is one.
    MapPointer newest()
    {
        const std::scoped_lock lock(mMutex);
        return mNewest;
    }
    //! True when the job has ended.
    bool wait(double seconds) const
    {
        const py::gil_scoped_release unlocked;
        return mMade.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
    }
    Result result() const
    {
        const py::gil_scoped_release unlocked;
        return mMade.get();
    }

private:
    std::atomic<bool> mStop;
    std::atomic<double> mShare = 0;
    std::mutex mMutex; //!< for the map
    MapPointer mNewest;
    std::shared_future<Result> mMade;
    std::thread mThread;
};

//! What a callback says; false when Ctrl-C comes meanwhile.
template <class Callback>
bool heard(Callback callback)
{
    try {
        return callback();
    } catch (py::error_already_set &error) {
        if (error.matches(PyExc_KeyboardInterrupt))
            return false;
        throw;
    }
}

//! Runs a job in the background, looks after it on this thread, and waits for its end. Ctrl-C stops it.
template <class Work>
auto run(const Callback &progress, const MapCallback &better, Work work)
{
    constexpr double tick = 0.05; // seconds
    using Result = std::invoke_result_t<Work, autocuts::Progress, autocuts::TakeMap>;
    const bool stopped = progress && !heard([&] { return (*progress)(0); });
    Background<Result> job(stopped, std::move(work));
    MapPointer seen;
    const auto tell = [&] {
        if (progress && !(*progress)(job.share()))
            return false;
        if (const MapPointer newest = job.newest(); better && newest != seen) {
            seen = newest;
            (*better)(newest);
        }
        return true;
    };
    while (!job.wait(tick)) {
        if (PyErr_CheckSignals() != 0) {
            PyErr_Clear();
            job.stop();
        }
        if (!heard(tell))
            job.stop();
    }
    heard(tell);
    return job.result();
}

using Call = autocuts::Map (*)(const autocuts::Mesh &, const autocuts::Options &, const autocuts::Progress &);

//! The functions that make a map of a mesh. \param takes takes better maps; empty: nobody wants them
MapPointer called(const std::string &name, const autocuts::Mesh &mesh, const autocuts::Options &options,
                  const autocuts::Progress &watch, const autocuts::TakeMap &takes)
{
    static const std::map<std::string, Call> calls{
        {"finish", autocuts::finish},
        {"pack", autocuts::pack},
        {"separate", autocuts::separate},
        {"align", autocuts::align},
        {"lightmap", autocuts::lightmap},
        {"take", [](const auto &m, const auto &o, const auto &) { return autocuts::take(m, o); }}};
    return std::make_shared<autocuts::Map>(name == "unwrap" ? autocuts::unwrap(mesh, options, watch, takes)
                                                            : calls.at(name)(mesh, options, watch));
}

py::dict figuresOf(const autocuts::Figures &figures)
{
    py::dict result;
    result["distortion"] = figures.distortion;
    result["seam_norm"] = figures.seam_norm;
    result["packing_efficiency"] = figures.packing_efficiency;
    result["gutter_texels"] = figures.gutter_texels;
    result["islands"] = figures.islands;
    result["flipped_triangles"] = figures.flipped_triangles;
    result["overlapping_pairs"] = figures.overlapping_pairs;
    return result;
}

void bindCalls(py::module_ &module)
{
    module.def(
        "call",
        [](const std::string &name, const Arrays &mesh, const autocuts::Options &options,
           const Callback &progress, const MapCallback &better) {
            return run(progress, better, [&](const autocuts::Progress &watch, const autocuts::TakeMap &take) {
                return called(name, mesh.view(), options, watch, better ? take : autocuts::TakeMap());
            });
        },
        py::arg("name"), py::arg("mesh"), py::arg("options"), py::arg("progress"), py::arg("better"));

    struct Measured
    {
        MapPointer map;
        autocuts::Figures figures;
    };
    using Job = Background<Measured>;
    py::class_<Job>(module, "Job")
        .def(py::init([](const std::string &name, const Arrays &mesh, const autocuts::Options &options) {
                 return std::make_unique<Job>(false, [name, &mesh, options](const autocuts::Progress &watch,
                                                                            const autocuts::TakeMap &take) {
                     const MapPointer map = called(name, mesh.view(), options, watch, take);
                     return Measured{map, map->measure()};
                 });
             }),
             py::keep_alive<1, 3>(), py::arg("name"), py::arg("mesh"), py::arg("options"))
        .def_property_readonly("share", &Job::share)
        .def_property_readonly("newest", &Job::newest)
        .def("stop", &Job::stop)
        .def("wait", &Job::wait, py::arg("seconds"))
        .def("result", [](const Job &job) { return job.result().map; })
        .def("figures", [](const Job &job) { return figuresOf(job.result().figures); });
}

py::dict outcomeOf(const autocuts::Outcome &outcome)
{
    py::dict result;
    result["stopped"] = outcome.stopped != 0;
    result["within_bound"] = outcome.within_bound != 0;
    result["hard_share"] = outcome.hard_share;
    result["unmet_pins"] = outcome.unmet_pins;
    result["unmet_joins"] = outcome.unmet_joins;
    result["missing_seams"] = outcome.missing_seams;
    return result;
}

void bindOptions(py::module_ &module)
{
    py::class_<autocuts::Options>(module, "Options")
        .def(py::init<>())
        .def_readwrite("quality", &autocuts::Options::quality)
        .def_readwrite("max_distortion", &autocuts::Options::max_distortion)
        .def_readwrite("seams", &autocuts::Options::seams)
        .def_readwrite("seams_from", &autocuts::Options::seams_from)
        .def_readwrite("sharp_angle", &autocuts::Options::sharp_angle)
        .def_readwrite("surface", &autocuts::Options::surface)
        .def_readwrite("flat_rigid", &autocuts::Options::flat_rigid)
        .def_readwrite("alike", &autocuts::Options::alike)
        .def_readwrite("creases", &autocuts::Options::creases)
        .def_readwrite("crease_strength", &autocuts::Options::crease_strength)
        .def_readwrite("visibility", &autocuts::Options::visibility)
        .def_readwrite("symmetry", &autocuts::Options::symmetry)
        .def_readwrite("mirror", &autocuts::Options::mirror)
        .def_readwrite("align", &autocuts::Options::align)
        .def_readwrite("world_up", &autocuts::Options::world_up)
        .def_readwrite("texture_width", &autocuts::Options::texture_width)
        .def_readwrite("texture_height", &autocuts::Options::texture_height)
        .def_readwrite("margin", &autocuts::Options::margin)
        .def_readwrite("tile_border", &autocuts::Options::tile_border)
        .def_readwrite("rotation", &autocuts::Options::rotation)
        .def_readwrite("keep_scale", &autocuts::Options::keep_scale)
        .def_readwrite("pack_time", &autocuts::Options::pack_time)
        .def_readwrite("density", &autocuts::Options::density)
        .def_readwrite("threads", &autocuts::Options::threads);

    py::class_<autocuts::BakeOptions>(module, "BakeOptions")
        .def(py::init<>())
        .def_readwrite("width", &autocuts::BakeOptions::width)
        .def_readwrite("height", &autocuts::BakeOptions::height)
        .def_readwrite("tile", &autocuts::BakeOptions::tile)
        .def_readwrite("samples", &autocuts::BakeOptions::samples)
        .def_readwrite("rays", &autocuts::BakeOptions::rays)
        .def_readwrite("cage", &autocuts::BakeOptions::cage)
        .def_readwrite("cage_direction", &autocuts::BakeOptions::cage_direction)
        .def_readwrite("ray_reach", &autocuts::BakeOptions::ray_reach)
        .def_readwrite("curvature_radius", &autocuts::BakeOptions::curvature_radius)
        .def_readwrite("thickness_limit", &autocuts::BakeOptions::thickness_limit)
        .def_readwrite("dilation", &autocuts::BakeOptions::dilation)
        .def_readwrite("directx", &autocuts::BakeOptions::directx)
        .def_readwrite("floats", &autocuts::BakeOptions::floats)
        .def_readwrite("threads", &autocuts::BakeOptions::threads);
}

void bindMap(py::module_ &module)
{
    py::class_<autocuts::Map, MapPointer>(module, "Map", py::dynamic_attr())
        .def_property_readonly("uvs",
                               [](const py::object &self) {
                                   const std::span<const double> uvs =
                                       self.cast<const autocuts::Map &>().uvs();
                                   return arrayOf(uvs, {py::ssize_t(uvs.size() / 2), 2}, self);
                               })
        .def_property_readonly("islands",
                               [](const py::object &self) {
                                   const auto islands = self.cast<const autocuts::Map &>().islands();
                                   return arrayOf(islands, {py::ssize_t(islands.size())}, self);
                               })
        .def_property_readonly("seams",
                               [](const py::object &self) {
                                   const auto seams = self.cast<const autocuts::Map &>().seams();
                                   return arrayOf(seams, {py::ssize_t(seams.size())}, self);
                               })
        .def_property_readonly("island_count", &autocuts::Map::islandCount)
        .def_property_readonly("stopped", &autocuts::Map::stopped)
        .def_property_readonly("outcome", [](const autocuts::Map &map) { return outcomeOf(map.outcome()); })
        .def("measure",
             [](const autocuts::Map &map) {
                 const auto measured = [&] {
                     const py::gil_scoped_release unlocked;
                     return map.measure();
                 };
                 return figuresOf(measured());
             })
        .def(
            "draw",
            [](const autocuts::Map &map, int width, int height, int tile) {
                const auto drawn = [&] {
                    const py::gil_scoped_release unlocked;
                    return map.draw(width, height, tile);
                };
                const std::vector<std::uint8_t> rgba = drawn();
                return Bytes({py::ssize_t(height), py::ssize_t(width), py::ssize_t(4)}, rgba.data());
            },
            py::arg("width"), py::arg("height"), py::arg("tile"));
}

void bindLiveSolve(py::module_ &module)
{
    py::class_<autocuts::LiveSolve>(module, "LiveSolve")
        .def(py::init([](const Arrays &mesh, const autocuts::Options &options) {
                 return std::make_unique<autocuts::LiveSolve>(mesh.view(), options);
             }),
             py::arg("mesh"), py::arg("options"))
        .def(
            "steer",
            [](autocuts::LiveSolve &live, const Arrays &mesh, const autocuts::Options &options) {
                live.steer(mesh.view(), options);
            },
            py::arg("mesh"), py::arg("options"))
        .def(
            "wait",
            [](autocuts::LiveSolve &live, double seconds) -> MapPointer {
                const py::gil_scoped_release unlocked;
                std::optional<autocuts::Map> map = live.wait(seconds);
                return map ? std::make_shared<autocuts::Map>(std::move(*map)) : nullptr;
            },
            py::arg("seconds"))
        .def("rests", &autocuts::LiveSolve::rests);
}

void bindTransfer(py::module_ &module)
{
    module.def(
        "transfer",
        [](const Arrays &source, const Arrays &mesh, int match, const autocuts::Options &options,
           const Callback &progress) {
            autocuts::Transferred figures{};
            const MapPointer map =
                run(progress, {}, [&](const autocuts::Progress &watch, const autocuts::TakeMap &) {
                    return std::make_shared<autocuts::Map>(
                        autocuts::transfer(source.view(), mesh.view(), static_cast<autocuts_match>(match),
                                           options, &figures, watch));
                });
            py::dict said;
            said["faces"] = figures.faces;
            said["copied"] = figures.copied;
            said["placed"] = figures.placed;
            said["mean_distance"] = figures.mean_distance;
            said["scale"] = figures.scale;
            return py::make_tuple(map, said);
        },
        py::arg("source"), py::arg("mesh"), py::arg("match"), py::arg("options"), py::arg("progress"));
}

void bindBake(py::module_ &module)
{
    module.def(
        "bake",
        [](const Arrays &mesh, const Arrays *high, const std::vector<int> &maps,
           autocuts::BakeOptions options, const std::optional<Doubles> &cage, const Callback &progress) {
            if (cage && cage->size() != mesh.positions.size())
                refuse("cage_positions must have the shape of positions");
            options.cage_positions = cage ? cage->data() : nullptr;
            const auto made =
                run(progress, {}, [&](const autocuts::Progress &watch, const autocuts::TakeMap &) {
                    const autocuts::Mesh detailed = high ? high->view() : autocuts::Mesh();
                    return std::make_shared<const autocuts::Bake>(
                        autocuts::bake(mesh.view(), high ? &detailed : nullptr, maps, options, watch));
                });
            py::list pictures;
            for (std::size_t i = 0; i < maps.size(); ++i)
                pictures.append(Floats({py::ssize_t(options.height), py::ssize_t(options.width),
                                        py::ssize_t(autocuts_bake_channels(maps[i]))},
                                       made->pictures[i].data()));
            return py::make_tuple(pictures, made->figures.texels, made->figures.missed);
        },
        py::arg("mesh"), py::arg("high"), py::arg("maps"), py::arg("options"), py::arg("cage"),
        py::arg("progress"));
}

} // namespace

PYBIND11_MODULE(_autocuts, module)
{
    module.doc() = "The binding of the package autocuts.";
    module.attr("version") = autocuts_version();

    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const autocuts::Error &error) {
            const bool input = error.status() == AUTOCUTS_BAD_INPUT;
            PyErr_SetString(input                                  ? PyExc_ValueError
                            : error.status() == AUTOCUTS_NO_MEMORY ? PyExc_MemoryError
                                                                   : PyExc_RuntimeError,
                            error.what());
        }
    });

    py::class_<Arrays>(module, "Arrays")
        .def(py::init(&arraysOf), py::arg("positions"), py::arg("faces"), py::arg("face_sizes"),
             py::arg("uvs"), py::arg("objects"), py::arg("materials"), py::arg("normals"), py::arg("colors"),
             py::arg("locked"), py::arg("edges"), py::arg("edge_weights"), py::arg("texel_weights"),
             py::arg("pins"));
    bindOptions(module);
    bindMap(module);
    bindCalls(module);
    bindTransfer(module);
    bindBake(module);
    bindLiveSolve(module);
}
