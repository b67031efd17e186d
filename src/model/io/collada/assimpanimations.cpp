#include "model/io/collada/assimpanimations.h"

#include "model/io/assimp/assimpmatrix.h"
#include "model/io/files/xmlspans.h"

#include <Eigen/Geometry>

#include <QByteArray>

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace autocuts {

namespace {

//! Between two matrices programs take straight ways, which shrinks what turns: by less than 1 % for this
//! angle. Chosen by hand.
constexpr double farthestTurn = 0.25; //!< radians

//! What a channel moves.
struct Target
{
    std::string path; //!< "id of the node/sid of its matrix"
    bool isBone = false;
    std::string matrix; //!< of the node, as it stands in the text
};

//! The targets by the name of the node.
std::map<std::string, Target> targetsIn(const XmlElement &element)
{
    std::map<std::string, Target> targets;
    const XmlElement *matrix = element.name == "node" ? element.child("matrix") : nullptr;
    if (matrix)
        targets[resolved(element.attribute("name"))] = {
            std::string(element.attribute("id")) + '/' + std::string(matrix->attribute("sid")),
            element.attribute("type") == "JOINT", std::string(matrix->content)};
    for (const XmlElement &child : element.children)
        targets.merge(targetsIn(child));
    return targets;
}

Eigen::Vector3d toVector(const aiVector3D &v)
{
    return {v.x, v.y, v.z};
}

Eigen::Quaterniond toTurn(const aiQuaternion &q)
{
    return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

//! The value of keys at a time. \param mix of two values and a share of the second one
template <typename Key, typename Convert, typename Mix>
auto valueAt(const Key *keys, unsigned count, double time, const Convert &convert, const Mix &mix)
{
    const Key *next = std::find_if(keys, keys + count, [time](const Key &key) { return key.mTime >= time; });
    if (next == keys || next == keys + count)
        return convert((next == keys ? keys : next - 1)->mValue);
    const Key *before = next - 1;
    const double share = (time - before->mTime) / (next->mTime - before->mTime);
    return mix(convert(before->mValue), convert(next->mValue), share);
}

//! A node in motion.
class Motion
{
public:
    //! \param above what is done after the motion
    Motion(const aiNodeAnim &channel, const aiNode &node, const Eigen::Matrix4d &above)
        : mChannel(channel), mAbove(above)
    {
        node.mTransformation.Decompose(mScaling, mTurn, mPlace);
    }

    Eigen::Affine3d at(double time) const
    {
        const auto line = [](const Eigen::Vector3d &a, const Eigen::Vector3d &b, double share) {
            return Eigen::Vector3d(a + share * (b - a));
        };
        const Eigen::Vector3d place =
            mChannel.mNumPositionKeys == 0
                ? toVector(mPlace)
                : valueAt(mChannel.mPositionKeys, mChannel.mNumPositionKeys, time, toVector, line);
        const Eigen::Vector3d scaling =
            mChannel.mNumScalingKeys == 0
                ? toVector(mScaling)
                : valueAt(mChannel.mScalingKeys, mChannel.mNumScalingKeys, time, toVector, line);
        return mAbove * Eigen::Affine3d(Eigen::Translation3d(place) * turnAt(time) * Eigen::Scaling(scaling));
    }

    //! In ticks.
    std::vector<double> times() const
    {
        std::set<double> keys;
        const auto collect = [&keys](const auto *list, unsigned count) {
            for (unsigned k = 0; k < count; ++k)
                keys.insert(list[k].mTime);
        };
        collect(mChannel.mPositionKeys, mChannel.mNumPositionKeys);
        collect(mChannel.mRotationKeys, mChannel.mNumRotationKeys);
        collect(mChannel.mScalingKeys, mChannel.mNumScalingKeys);
        std::vector<double> times;
        for (const double key : keys) {
            const double before = times.empty() ? key : times.back();
            const double turn = turnAt(before).angularDistance(turnAt(key));
            const int steps = std::max(1, static_cast<int>(std::ceil(turn / farthestTurn)));
            for (int step = 1; step < steps; ++step)
                times.push_back(before + step * (key - before) / steps);
            times.push_back(key);
        }
        return times;
    }

private:
    Eigen::Quaterniond turnAt(double time) const
    {
        if (mChannel.mNumRotationKeys == 0)
            return toTurn(mTurn);
        return valueAt(mChannel.mRotationKeys, mChannel.mNumRotationKeys, time, toTurn,
                       [](const Eigen::Quaterniond &a, const Eigen::Quaterniond &b, double share) {
                           return a.slerp(share, b);
                       });
    }

    const aiNodeAnim &mChannel;
    Eigen::Affine3d mAbove;
    aiVector3D mScaling, mPlace;
    aiQuaternion mTurn;
};

std::string numbers(const std::vector<double> &values)
{
    QByteArray text;
    for (const double value : values)
        text += (text.isEmpty() ? "" : " ") + QByteArray::number(value, 'g', 9);
    return text.toStdString();
}

//! \param type of the values \param size numbers of a value; 0: they are words
std::string source(const std::string &id, const std::string &values, std::size_t count, std::size_t size,
                   const std::string &name, const std::string &type)
{
    const std::string array = size == 0 ? "Name_array" : "float_array";
    const std::size_t stride = std::max<std::size_t>(size, 1);
    return "        <source id=\"" + id + "\">\n          <" + array + " id=\"" + id + "-array\" count=\"" +
           std::to_string(count * stride) + "\">" + values + "</" + array +
           ">\n          <technique_common>\n            <accessor source=\"#" + id + "-array\" count=\"" +
           std::to_string(count) + "\" stride=\"" + std::to_string(stride) +
           "\">\n              <param name=\"" + name + "\" type=\"" + type +
           "\"/>\n            </accessor>\n          </technique_common>\n        </source>\n";
}

//! One channel as an element of its own. \param places a matrix for each time \param target of the channel
std::string animated(const std::vector<double> &seconds, const std::string &places, const std::string &target,
                     const std::string &id)
{
    const std::size_t count = seconds.size();
    std::string ways = "LINEAR";
    for (std::size_t k = 1; k < count; ++k)
        ways += " LINEAR";
    return "      <animation id=\"" + id + "\">\n" +
           source(id + "-times", numbers(seconds), count, 1, "TIME", "float") +
           source(id + "-places", places, count, 16, "TRANSFORM", "float4x4") +
           source(id + "-ways", ways, count, 0, "INTERPOLATION", "name") + "        <sampler id=\"" + id +
           "-sampler\">\n          <input semantic=\"INPUT\" source=\"#" + id +
           "-times\"/>\n          <input semantic=\"OUTPUT\" source=\"#" + id +
           "-places\"/>\n          <input semantic=\"INTERPOLATION\" source=\"#" + id +
           "-ways\"/>\n        </sampler>\n        <channel source=\"#" + id + "-sampler\" target=\"" +
           target + "\"/>\n      </animation>\n";
}

std::string animated(const Motion &motion, double perSecond, const std::string &target, const std::string &id)
{
    std::vector<double> seconds, matrices;
    for (const double time : motion.times()) {
        seconds.push_back(time / perSecond);
        const Eigen::Matrix4d rows = motion.at(time).matrix().transpose();
        matrices.insert(matrices.end(), rows.data(), rows.data() + 16);
    }
    return animated(seconds, numbers(matrices), target, id);
}

bool isSkinned(const aiScene &scene, const aiNode &node)
{
    return node.mNumChildren == 0 &&
           std::any_of(node.mMeshes, node.mMeshes + node.mNumMeshes,
                       [&scene](unsigned mesh) { return scene.mMeshes[mesh]->mNumBones > 0; });
}

} // namespace

std::string withAnimations(std::string_view text, const aiScene &scene, const NodeChanges &changes)
{
    const std::optional<XmlElement> root = scene.mNumAnimations > 0 ? xmlSpans(text) : std::nullopt;
    const XmlElement *scenes = root ? root->child("library_visual_scenes") : nullptr;
    if (!scenes)
        return std::string(text);
    std::map<std::string, Target> targets = targetsIn(*scenes);
    const aiAnimation &animation = *scene.mAnimations[0];
    const double perSecond = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;
    std::string channels;
    double start = std::numeric_limits<double>::max(); // in ticks
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        const aiNodeAnim &channel = *animation.mChannels[c];
        const aiNode *node = scene.mRootNode->FindNode(channel.mNodeName);
        const auto target = targets.find(channel.mNodeName.C_Str());
        const auto before = changes.before.find(channel.mNodeName.C_Str());
        const Motion motion(channel, node ? *node : *scene.mRootNode,
                            before == changes.before.end() ? Eigen::Matrix4d::Identity() : before->second);
        if (node && target != targets.end() && !isSkinned(scene, *node) && !motion.times().empty() &&
            !changes.still.contains(channel.mNodeName.C_Str())) {
            channels += animated(motion, perSecond, target->second.path, "motion" + std::to_string(c));
            targets.erase(target);
            start = std::min(start, motion.times().front());
        }
    }
    if (channels.empty())
        return std::string(text);
    std::size_t still = 0;
    for (const auto &[name, target] : targets) {
        if (target.isBone)
            channels +=
                animated({start / perSecond}, target.matrix, target.path, "still" + std::to_string(still++));
    }
    const std::string library = "<library_animations>\n    <animation id=\"motion\">\n" + channels +
                                "    </animation>\n  </library_animations>\n  ";
    return edited(text, {{scenes->whole.data(), scenes->whole.data(), library}});
}

} // namespace autocuts
