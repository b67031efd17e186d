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
#include <memory>
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
    Doubles positions, uvs;
    Indices indices, sizes;
    Ints objects;
    Bytes locked, edges;

    autocuts::Mesh view() const
    {
        return {spanOf(positions), spanOf(indices), spanOf(sizes), spanOf(objects),
                spanOf(uvs),       spanOf(locked),  spanOf(edges)};
    }
};

Arrays arraysOf(const Doubles &positions, const Signed &faces, const std::optional<Signed> &faceSizes,
                const std::optional<Doubles> &uvs, const std::optional<Ints> &objects,
                const std::optional<Bytes> &locked, const std::optional<Bytes> &edges)
{
    if (positions.ndim() != 2 || positions.shape(1) != 3)
        refuse("positions must be an Nx3 array");
    if (faceSizes ? faces.ndim() != 1 : faces.ndim() != 2 || faces.shape(1) < 3)
        refuse(faceSizes ? "with face_sizes, faces must be a flat array of the vertices of all corners"
                         : "faces must be an Fx3 array of vertices, or Fx4 and so on");
    Arrays arrays;
    arrays.positions = positions;
    arrays.indices = Indices(faces.size());
    for (py::ssize_t i = 0; i < faces.size(); ++i) {
        const std::int64_t vertex = faces.data()[i];
        if (vertex < 0 || vertex >= positions.shape(0))
            refuse("entry " + std::to_string(i) + " of faces is " + std::to_string(vertex) +
                   ", out of range: there are " + std::to_string(positions.shape(0)) + " vertices");
        arrays.indices.mutable_data()[i] = std::uint32_t(vertex);
    }
    if (faceSizes) {
        arrays.sizes = Indices(*faceSizes);
    } else if (faces.shape(1) != 3) {
        arrays.sizes = Indices(faces.shape(0));
        std::fill_n(arrays.sizes.mutable_data(), faces.shape(0), std::uint32_t(faces.shape(1)));
    }
    if (uvs) {
        if (uvs->size() != 2 * faces.size())
            refuse("uvs must have two numbers per corner: the shape of faces, and 2");
        arrays.uvs = *uvs;
    }
    if (objects)
        arrays.objects = *objects;
    if (locked)
        arrays.locked = *locked;
    if (edges)
        arrays.edges = *edges;
    return arrays;
}

template <class T>
py::array arrayOf(std::span<const T> values, std::vector<py::ssize_t> shape, const py::object &owner)
{
    py::array array(py::dtype::of<T>(), std::move(shape), values.data(), owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

using Call = autocuts::Map (*)(const autocuts::Mesh &, const autocuts::Options &, const autocuts::Progress &);

//! Runs a job on a thread of its own, without the interpreter's lock, so that this one can hear Ctrl-C, which
//! ends the job with the best map so far.
std::shared_ptr<autocuts::Map> run(Call call, const Arrays &arrays, const autocuts::Options &options,
                                   const std::optional<std::function<bool(double)>> &progress)
{
    constexpr std::chrono::milliseconds tick(50);
    std::atomic<bool> stop = false;
    std::exception_ptr thrown; // by the callback
    const autocuts::Progress watch = [&](double fraction) {
        if (stop || !progress)
            return !stop;
        const py::gil_scoped_acquire lock;
        try {
            if (!(*progress)(fraction))
                stop = true;
        } catch (...) {
            thrown = std::current_exception();
            stop = true;
        }
        return !stop;
    };
    const autocuts::Mesh view = arrays.view();
    std::packaged_task<autocuts::Map()> task([&] { return call(view, options, watch); });
    std::future<autocuts::Map> made = task.get_future();
    {
        const py::gil_scoped_release unlocked;
        const std::jthread worker(std::move(task));
        while (made.wait_for(tick) != std::future_status::ready) {
            const py::gil_scoped_acquire lock;
            if (PyErr_CheckSignals() != 0) {
                PyErr_Clear();
                stop = true;
            }
        }
    }
    if (thrown)
        std::rethrow_exception(thrown);
    return std::make_shared<autocuts::Map>(made.get());
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

    py::class_<autocuts::Options>(module, "Options")
        .def(py::init<>())
        .def_readwrite("quality", &autocuts::Options::quality)
        .def_readwrite("max_distortion", &autocuts::Options::max_distortion)
        .def_readwrite("surface", &autocuts::Options::surface)
        .def_readwrite("symmetry", &autocuts::Options::symmetry)
        .def_readwrite("align", &autocuts::Options::align)
        .def_readwrite("texture_width", &autocuts::Options::texture_width)
        .def_readwrite("texture_height", &autocuts::Options::texture_height)
        .def_readwrite("margin", &autocuts::Options::margin)
        .def_readwrite("border", &autocuts::Options::border)
        .def_readwrite("rotation", &autocuts::Options::rotation)
        .def_readwrite("keep_scale", &autocuts::Options::keep_scale)
        .def_readwrite("pack_effort", &autocuts::Options::pack_effort)
        .def_readwrite("density", &autocuts::Options::density)
        .def_readwrite("threads", &autocuts::Options::threads);

    py::class_<autocuts::Map, std::shared_ptr<autocuts::Map>>(module, "Map")
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
        .def("measure", [](const autocuts::Map &map) {
            autocuts::Figures figures;
            {
                const py::gil_scoped_release unlocked;
                figures = map.measure();
            }
            py::dict result;
            result["distortion"] = figures.distortion;
            result["seam_norm"] = figures.seam_norm;
            result["packing_efficiency"] = figures.packing_efficiency;
            result["gutter_texels"] = figures.gutter_texels;
            result["islands"] = figures.islands;
            result["flipped_triangles"] = figures.flipped_triangles;
            result["overlapping_pairs"] = figures.overlapping_pairs;
            return result;
        });

    const auto take = [](const autocuts::Mesh &mesh, const autocuts::Options &options,
                         const autocuts::Progress &) { return autocuts::take(mesh, options); };
    for (const auto &[name, call] : {std::pair<const char *, Call>{"unwrap", autocuts::unwrap},
                                     {"pack", autocuts::pack},
                                     {"separate", autocuts::separate},
                                     {"take", take}}) {
        module.def(
            name,
            [call = call](const Doubles &positions, const Signed &faces,
                          const std::optional<Signed> &faceSizes, const std::optional<Doubles> &uvs,
                          const std::optional<Ints> &objects, const std::optional<Bytes> &locked,
                          const std::optional<Bytes> &edges, const autocuts::Options &options,
                          const std::optional<std::function<bool(double)>> &progress) {
                return run(call, arraysOf(positions, faces, faceSizes, uvs, objects, locked, edges), options,
                           progress);
            },
            py::arg("positions"), py::arg("faces"), py::arg("face_sizes"), py::arg("uvs"), py::arg("objects"),
            py::arg("locked"), py::arg("edges"), py::arg("options"), py::arg("progress"));
    }
}
