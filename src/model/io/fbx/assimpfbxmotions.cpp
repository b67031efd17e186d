#include "model/io/fbx/assimpfbxmotions.h"

#include "model/io/assimp/assimpmatrix.h"
#include "model/io/fbx/fbxlinks.h"
#include "model/io/fbx/fbxobjects.h"
#include "model/io/fbx/fbxproperties.h"
#include "model/io/fbx/fbxtransforms.h"

#include <Eigen/Geometry>

#include <assimp/scene.h>
#include <functional>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace autocuts {

namespace {

constexpr double ticksInSecond = 46186158000.0; //!< of FBX
//! Degrees. Between two keys programs take straight ways: on an arc of this length they are off by less than
//! 1 % of its radius. Chosen by hand; assimpanimations puts nothing between such keys.
constexpr double farthestAngle = 14;
//! A motion may get this many keys; a damaged file has angles without end.
constexpr std::size_t mostKeys = 100000;
//! Sizes of a model along its axes that differ more, as shares of the largest, hide what is behind them.
constexpr double flatModel = 1e-4;

//! A number over time.
struct Curve
{
    std::vector<double> times, values;

    //! Along straight lines.
    double at(double time) const
    {
        const auto next = std::ranges::lower_bound(times, time);
        const auto n = static_cast<std::size_t>(next - times.begin());
        if (n == 0 || next == times.end())
            return values[n == 0 ? 0 : n - 1];
        const double share = (time - times[n - 1]) / (times[n] - times[n - 1]);
        return values[n - 1] + share * (values[n] - values[n - 1]);
    }
};

//! The place, the angles or the sizes of a model over time.
struct Track
{
    Vec3 still; //!< of components without a curve
    std::array<Curve, 3> curves;
    bool found = false;

    Vec3 at(double time) const
    {
        Vec3 value = still;
        for (int k = 0; k < 3; ++k) {
            const Curve &curve = curves[static_cast<std::size_t>(k)];
            if (!curve.times.empty())
                value[k] = curve.at(time);
        }
        return value;
    }
};

//! A model in motion.
struct Motion
{
    std::int64_t model = 0;
    Track place, angles, sizes;

    FbxPlacing at(double time) const { return {place.at(time), angles.at(time), sizes.at(time)}; }

    //! The times of all keys.
    std::set<double> keys() const
    {
        std::set<double> times;
        for (const Track *track : {&place, &angles, &sizes}) {
            for (const Curve &curve : track->curves)
                times.insert(curve.times.begin(), curve.times.end());
        }
        return times;
    }
};

class Stack
{
public:
    Stack(const FbxTree &tree, const FbxLinks &links, std::int64_t id) : mTree(tree), mLinks(links)
    {
        for (const FbxLink &link : links.to(id)) {
            if (nameOf(link.child) == "AnimationLayer")
                mLayers.push_back(link.child);
        }
        for (const std::int64_t layer : mLayers) {
            for (const FbxLink &link : links.to(layer))
                mLayerOf.emplace(link.child, layer);
        }
    }

    //! Nothing for models without a motion.
    std::optional<Motion> motionOf(std::int64_t model) const
    {
        const FbxProperties p(mTree, mLinks.node(model));
        const FbxPlacing still = fbxPlacing(p);
        Motion motion{model, {still.translation, {}}, {still.rotation, {}}, {still.scaling, {}}};
        bool found = false;
        for (const FbxLink &link : mLinks.to(model)) {
            Track *track = link.property == "Lcl Translation" ? &motion.place
                           : link.property == "Lcl Rotation"  ? &motion.angles
                           : link.property == "Lcl Scaling"   ? &motion.sizes
                                                              : nullptr;
            if (!track || !mLayerOf.contains(link.child))
                continue;
            // Of the first layer; nothing here mixes layers.
            if (!track->found)
                found = readTrack(*track, link.child) || found;
        }
        return found ? std::optional(std::move(motion)) : std::nullopt;
    }

private:
    std::string_view nameOf(std::int64_t id) const
    {
        const int node = mLinks.node(id);
        return node < 0 ? std::string_view() : mTree.name(node);
    }

    //! False without curves.
    bool readTrack(Track &track, std::int64_t curveNode) const
    {
        track.found = true;
        const FbxProperties p(mTree, mLinks.node(curveNode));
        bool hasCurve = false;
        for (int k = 0; k < 3; ++k) {
            const std::string_view component = std::array{"d|X", "d|Y", "d|Z"}[static_cast<std::size_t>(k)];
            if (const std::vector<double> value = p.numbers(component); !value.empty())
                track.still[k] = value[0];
            for (const FbxLink &link : mLinks.to(curveNode)) {
                if (link.property == component)
                    hasCurve = readCurve(track.curves[static_cast<std::size_t>(k)], link.child) || hasCurve;
            }
        }
        return hasCurve;
    }

    bool readCurve(Curve &curve, std::int64_t id) const
    {
        const int node = mLinks.node(id);
        std::optional<std::vector<double>> times = mTree.doubles(mTree.child(node, "KeyTime"));
        std::optional<std::vector<double>> values = mTree.doubles(mTree.child(node, "KeyValueFloat"));
        const auto finite = [](double value) { return std::isfinite(value); };
        if (!times || !values || times->empty() || times->size() != values->size() ||
            !std::ranges::all_of(*times, finite) || !std::ranges::all_of(*values, finite) ||
            std::ranges::adjacent_find(*times, std::greater_equal<>()) != times->end())
            return false;
        curve = {std::move(*times), std::move(*values)};
        return true;
    }

    const FbxTree &mTree;
    const FbxLinks &mLinks;
    std::vector<std::int64_t> mLayers;
    std::map<std::int64_t, std::int64_t> mLayerOf; //!< by curve node
};

//! From when to when an animation lasts, and how Assimp counts its time.
struct Span
{
    double start = 0, stop = 0; //!< ticks of FBX
    double perSecond = 25;      //!< ticks of Assimp

    double toAssimp(double time) const { return (time - start) / ticksInSecond * perSecond; }
};

//! The times of keys, and of what is between them where the model turns far.
std::vector<double> timesOf(const Motion &motion, const Span &span)
{
    std::vector<double> times;
    for (const double key : motion.keys()) {
        if (key < span.start || key > span.stop)
            continue;
        const double before = times.empty() ? key : times.back();
        const double turn = (motion.angles.at(key) - motion.angles.at(before)).cwiseAbs().sum();
        const double steps = std::ceil(turn / farthestAngle);
        if (!(times.size() + steps < mostKeys))
            return {};
        for (int step = 1; step < steps; ++step)
            times.push_back(before + step * (key - before) / steps);
        times.push_back(key);
    }
    return times;
}

//! What follows the transform of the model in that of Assimp's node.
Eigen::Affine3d behindModel(const Eigen::Affine3d &model, const aiNode &node)
{
    const Eigen::Vector3d sizes = model.linear().colwise().norm();
    if (!(sizes.minCoeff() > flatModel * sizes.maxCoeff()))
        return Eigen::Affine3d::Identity();
    const Eigen::Affine3d behind = model.inverse() * Eigen::Affine3d(toEigen(node.mTransformation));
    return behind.isApprox(Eigen::Affine3d::Identity(), 1e-4) ? Eigen::Affine3d::Identity() : behind;
}

aiVector3D toAssimp(const Eigen::Vector3d &v)
{
    return {static_cast<ai_real>(v.x()), static_cast<ai_real>(v.y()), static_cast<ai_real>(v.z())};
}

//! The keys of a motion.
std::unique_ptr<aiNodeAnim> channelOf(const Motion &motion, const std::vector<double> &times,
                                      const Span &span, const FbxProperties &p, const aiNode &node)
{
    auto channel = std::make_unique<aiNodeAnim>();
    channel->mNodeName = node.mName;
    const auto count = static_cast<unsigned>(times.size());
    channel->mPositionKeys = new aiVectorKey[count];
    channel->mRotationKeys = new aiQuatKey[count];
    channel->mScalingKeys = new aiVectorKey[count];
    channel->mNumPositionKeys = channel->mNumRotationKeys = channel->mNumScalingKeys = count;
    const Eigen::Affine3d behind = behindModel(fbxLocalTransform(p, fbxPlacing(p)), node);
    Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
    for (unsigned k = 0; k < count; ++k) {
        FbxPlacing placing = motion.at(times[k]);
        const Eigen::Affine3d place = fbxLocalTransform(p, placing) * behind;
        Eigen::Vector3d sizes = placing.scaling;
        placing.scaling = Vec3::Ones();
        Eigen::Matrix3d turn = fbxLocalTransform(p, placing).linear();
        if (!behind.linear().isIdentity(0)) {
            sizes = place.linear().colwise().norm();
            if (place.linear().determinant() < 0)
                sizes = -sizes;
            turn = place.linear() * sizes.cwiseInverse().asDiagonal();
        }
        Eigen::Quaterniond q = Eigen::Quaterniond(turn).normalized();
        if (q.dot(last) < 0)
            q.coeffs() = -q.coeffs();
        last = q;
        const double time = span.toAssimp(times[k]);
        channel->mPositionKeys[k] = {time, toAssimp(Eigen::Vector3d(place.translation()))};
        channel->mScalingKeys[k] = {time, toAssimp(sizes)};
        channel->mRotationKeys[k] = {time,
                                     aiQuaternion(static_cast<ai_real>(q.w()), static_cast<ai_real>(q.x()),
                                                  static_cast<ai_real>(q.y()), static_cast<ai_real>(q.z()))};
    }
    return channel;
}

void addChannel(aiAnimation &animation, std::unique_ptr<aiNodeAnim> channel)
{
    auto **channels = new aiNodeAnim *[animation.mNumChannels + 1];
    std::copy_n(animation.mChannels, animation.mNumChannels, channels);
    channels[animation.mNumChannels++] = channel.release();
    delete[] animation.mChannels;
    animation.mChannels = channels;
}

bool isMoved(const aiAnimation &animation, const aiString &node)
{
    return std::any_of(animation.mChannels, animation.mChannels + animation.mNumChannels,
                       [&node](const aiNodeAnim *channel) { return channel->mNodeName == node; });
}

//! As Assimp takes it: what the stack says, or else from the first key to the last one.
Span spanOf(const FbxTree &tree, int stack, const std::vector<Motion> &motions, double perSecond)
{
    const FbxProperties p(tree, stack);
    const auto timeOf = [&p](const char *name) {
        const std::vector<double> values = p.numbers(name);
        return values.empty() ? 0 : values[0];
    };
    Span span{timeOf("LocalStart"), timeOf("LocalStop"), perSecond};
    if (span.start != 0 || span.stop != 0)
        return span;
    span.start = std::numeric_limits<double>::max();
    span.stop = std::numeric_limits<double>::lowest();
    for (const Motion &motion : motions) {
        if (const std::set<double> keys = motion.keys(); !keys.empty()) {
            span.start = std::min(span.start, *keys.begin());
            span.stop = std::max(span.stop, *keys.rbegin());
        }
    }
    return span;
}

} // namespace

void completeFbxMotions(aiScene &scene, const FbxTree &tree, const FbxLinks &links)
{
    const std::map<std::string, std::int64_t> models = links.modelsByName();
    std::set<aiAnimation *> done;
    for (const std::int64_t id : links.objects("AnimationStack")) {
        const std::vector<FbxValue> values = tree.values(links.node(id), 2);
        const std::string name =
            fbxObjectName(tree, values.size() < 2 ? std::string_view() : values[1].text).toStdString();
        aiAnimation **const end = scene.mAnimations + scene.mNumAnimations;
        aiAnimation **const found = std::find_if(scene.mAnimations, end, [&](aiAnimation *animation) {
            return name == animation->mName.C_Str() && !done.contains(animation);
        });
        if (found == end)
            continue;
        aiAnimation &animation = **found;
        done.insert(&animation);
        const Stack stack(tree, links, id);
        std::vector<Motion> motions;
        std::vector<const aiNode *> nodes;
        for (const auto &[model, number] : models) {
            const aiNode *node = scene.mRootNode->FindNode(model.c_str());
            std::optional<Motion> motion = node ? stack.motionOf(number) : std::nullopt;
            if (!motion)
                continue;
            motions.push_back(std::move(*motion));
            nodes.push_back(node);
        }
        const double perSecond = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;
        const Span span = spanOf(tree, links.node(id), motions, perSecond);
        for (std::size_t m = 0; m < motions.size(); ++m) {
            const std::vector<double> times = timesOf(motions[m], span);
            if (!times.empty() && !isMoved(animation, nodes[m]->mName))
                addChannel(animation,
                           channelOf(motions[m], times, span,
                                     FbxProperties(tree, links.node(motions[m].model)), *nodes[m]));
        }
    }
}

} // namespace autocuts
