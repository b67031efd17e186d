#include "model/io/assimp/assimpstream.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace autocuts {

namespace {

constexpr std::uint64_t beginMark = 0x31454e4543534341; //!< "ACSCENE1"
constexpr std::uint64_t endMark = 0x444e45454e454353;   //!< "SCENEEND"
//! The node tree is read recursively; deeper ones are refused. Chosen by hand.
constexpr int maxDepth = 2000;

//! Values that are written as their bytes.
template <typename T>
constexpr bool isPlain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

//! Writes values to a file.
class Output
{
public:
    static constexpr bool reads = false;

    explicit Output(std::FILE *file) : mFile(file) {}

    void bytes(const void *data, std::size_t size)
    {
        if (size > 0 && std::fwrite(data, 1, size, mFile) != size)
            throw std::runtime_error("the scene cannot be passed on");
    }
    void take(std::size_t) {}
    template <typename T>
    void allocate(T *&, std::size_t)
    {}

private:
    std::FILE *mFile;
};

//! Reads values from bytes.
class Input
{
public:
    static constexpr bool reads = true;

    Input(std::span<const char> bytes, std::size_t memory) : mBytes(bytes), mMemory(memory) {}

    void bytes(void *data, std::size_t size)
    {
        if (size > mBytes.size())
            throw std::runtime_error("the scene breaks off");
        if (size > 0)
            std::memcpy(data, mBytes.data(), size);
        mBytes = mBytes.subspan(size);
    }
    //! Counts memory that is about to be taken.
    void take(std::size_t size)
    {
        if (size > mMemory)
            throw std::runtime_error("the scene is too large");
        mMemory -= size;
    }
    //! Makes an array, null for no elements, which Assimp would not delete. Each element takes at least one
    //! byte of the input.
    template <typename T>
    void allocate(T *&data, std::size_t count)
    {
        if (count > mBytes.size())
            throw std::runtime_error("the scene breaks off");
        take(count * sizeof(T));
        data = count > 0 ? new T[count]() : nullptr;
    }
    bool atEnd() const { return mBytes.empty(); }

private:
    std::span<const char> mBytes;
    std::size_t mMemory;
};

//! Passes a scene through an Output or an Input: one description of the form for both. What an Input fills is
//! safe to destroy at every moment.
template <class Archive>
class Transfer
{
public:
    explicit Transfer(Archive &archive) : mArchive(archive) {}

    void pass(aiScene &scene)
    {
        mark(beginMark);
        values(scene.mFlags, scene.mName);
        optional(scene.mMetaData);
        objects(scene.mMeshes, scene.mNumMeshes);
        objects(scene.mMaterials, scene.mNumMaterials);
        objects(scene.mAnimations, scene.mNumAnimations);
        objects(scene.mTextures, scene.mNumTextures);
        objects(scene.mLights, scene.mNumLights);
        objects(scene.mCameras, scene.mNumCameras);
        optional(scene.mRootNode);
        if (!scene.mRootNode)
            throw std::runtime_error("the scene has no root");
        mark(endMark);
    }

private:
    template <typename T>
    requires(isPlain<T> && !std::is_enum_v<T>) void pass(T &value) { mArchive.bytes(&value, sizeof value); }

    //! Assimp's enumerations hold at least all of 0 to INT_MAX; what is beyond is no value of theirs.
    template <typename T>
    requires std::is_enum_v<T>
    void pass(T &value)
    {
        auto number = static_cast<std::uint32_t>(value);
        pass(number);
        if (number > std::uint32_t(std::numeric_limits<int>::max()))
            throw std::runtime_error("the scene is damaged");
        value = static_cast<T>(number);
    }

    void pass(bool &value)
    {
        auto byte = static_cast<std::uint8_t>(value);
        pass(byte);
        value = byte != 0;
    }

    void pass(aiColor3D &color) { values(color.r, color.g, color.b); }

    void pass(aiString &text)
    {
        ai_uint32 length = std::min<ai_uint32>(text.length, MAXLEN - 1);
        pass(length);
        if (length >= MAXLEN)
            throw std::runtime_error("a name is too long");
        mArchive.bytes(text.data, length);
        if constexpr (Archive::reads) {
            text.length = length;
            text.data[length] = '\0';
        }
    }

    template <typename... T>
    void values(T &...value)
    {
        (pass(value), ...);
    }

    void mark(std::uint64_t expected)
    {
        std::uint64_t found = expected;
        pass(found);
        if (found != expected)
            throw std::runtime_error("this is not a scene");
    }

    //! True when there is something behind the pointer, which is null before reading.
    bool present(const void *pointer)
    {
        auto is = static_cast<std::uint8_t>(pointer != nullptr);
        pass(is);
        return is != 0;
    }

    //! An array of `count` elements or null. The count has been passed before.
    template <typename T>
    void array(T *&data, std::size_t count)
    {
        if (!present(data))
            return;
        mArchive.allocate(data, count);
        if constexpr (isPlain<T>) {
            mArchive.bytes(data, count * sizeof(T));
        } else {
            for (std::size_t i = 0; i < count; ++i)
                pass(data[i]);
        }
    }

    //! An array with its count.
    template <typename T>
    void list(T *&data, unsigned &count)
    {
        unsigned size = data ? count : 0;
        pass(size);
        array(data, size);
        count = data ? size : 0;
    }

    //! An array of pointers to objects, some of which may be null.
    template <typename T>
    void objects(T **&data, unsigned &count)
    {
        unsigned size = data ? count : 0;
        pass(size);
        if (!present(size > 0 ? data : nullptr))
            return;
        mArchive.allocate(data, size);
        count = size;
        for (unsigned i = 0; i < size; ++i)
            optional(data[i]);
    }

    template <typename T>
    void optional(T *&object)
    {
        if (!present(object))
            return;
        mArchive.take(sizeof(T));
        if constexpr (Archive::reads)
            object = new T;
        pass(*object);
    }

    void pass(aiNode &node)
    {
        Level level(mDepth);
        values(node.mName, node.mTransformation);
        list(node.mMeshes, node.mNumMeshes);
        optional(node.mMetaData);
        objects(node.mChildren, node.mNumChildren);
        for (unsigned c = 0; c < node.mNumChildren; ++c) {
            if (!node.mChildren[c])
                throw std::runtime_error("a node is missing");
            if constexpr (Archive::reads)
                node.mChildren[c]->mParent = &node;
        }
    }

    void pass(aiMetadata &data)
    {
        Level level(mDepth);
        unsigned count = data.mKeys && data.mValues ? data.mNumProperties : 0;
        pass(count);
        mArchive.allocate(data.mKeys, count);
        mArchive.allocate(data.mValues, count);
        data.mNumProperties = count;
        for (unsigned i = 0; i < count; ++i) {
            pass(data.mKeys[i]);
            pass(data.mValues[i]);
        }
    }

    void pass(aiMetadataEntry &entry)
    {
        // A value without data is copied as one of no known type.
        aiMetadataType type = entry.mData ? entry.mType : AI_META_MAX;
        pass(type);
        entry.mType = type;
        switch (type) {
        case AI_BOOL:
            return metaValue<bool>(entry);
        case AI_INT32:
            return metaValue<std::int32_t>(entry);
        case AI_UINT64:
            return metaValue<std::uint64_t>(entry);
        case AI_FLOAT:
            return metaValue<float>(entry);
        case AI_DOUBLE:
            return metaValue<double>(entry);
        case AI_AISTRING:
            return metaValue<aiString>(entry);
        case AI_AIVECTOR3D:
            return metaValue<aiVector3D>(entry);
        case AI_AIMETADATA:
            return metaValue<aiMetadata>(entry);
        default:
            entry.mType = AI_META_MAX;
        }
    }

    template <typename T>
    void metaValue(aiMetadataEntry &entry)
    {
        mArchive.take(sizeof(T));
        if constexpr (Archive::reads)
            entry.mData = new T();
        pass(*static_cast<T *>(entry.mData));
    }

    void pass(aiFace &face) { list(face.mIndices, face.mNumIndices); }

    void pass(aiBone &bone)
    {
        values(bone.mName, bone.mOffsetMatrix);
        list(bone.mWeights, bone.mNumWeights);
    }

    void pass(aiAnimMesh &mesh)
    {
        values(mesh.mName, mesh.mNumVertices, mesh.mWeight);
        vertexData(mesh);
    }

    //! The arrays that a mesh and its morph targets have in common.
    template <class Mesh>
    void vertexData(Mesh &mesh)
    {
        for (aiVector3D **data : {&mesh.mVertices, &mesh.mNormals, &mesh.mTangents, &mesh.mBitangents})
            array(*data, mesh.mNumVertices);
        for (aiColor4D *&colors : mesh.mColors)
            array(colors, mesh.mNumVertices);
        for (aiVector3D *&uvs : mesh.mTextureCoords)
            array(uvs, mesh.mNumVertices);
    }

    void pass(aiMesh &mesh)
    {
        values(mesh.mName, mesh.mPrimitiveTypes, mesh.mNumVertices, mesh.mMaterialIndex, mesh.mMethod,
               mesh.mAABB.mMin, mesh.mAABB.mMax, mesh.mNumUVComponents);
        vertexData(mesh);
        list(mesh.mFaces, mesh.mNumFaces);
        if (present(mesh.mTextureCoordsNames)) {
            mArchive.allocate(mesh.mTextureCoordsNames, AI_MAX_NUMBER_OF_TEXTURECOORDS);
            for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++set)
                optional(mesh.mTextureCoordsNames[set]);
        }
        objects(mesh.mBones, mesh.mNumBones);
        objects(mesh.mAnimMeshes, mesh.mNumAnimMeshes);
        if (std::count(mesh.mBones, mesh.mBones + mesh.mNumBones, nullptr) > 0 ||
            std::count(mesh.mAnimMeshes, mesh.mAnimMeshes + mesh.mNumAnimMeshes, nullptr) > 0)
            throw std::runtime_error("a bone or a morph target is missing");
    }

    void pass(aiMaterial &material)
    {
        unsigned count = material.mNumProperties;
        pass(count);
        if constexpr (Archive::reads) {
            aiMaterialProperty **properties = nullptr;
            mArchive.allocate(properties, count);
            // A material without properties keeps the room that its constructor made.
            if (count > 0) {
                std::swap(material.mProperties, properties);
                material.mNumAllocated = count;
            }
            delete[] properties;
            material.mNumProperties = count;
        }
        for (unsigned i = 0; i < count; ++i) {
            optional(material.mProperties[i]);
            if (!material.mProperties[i])
                throw std::runtime_error("a material's property is missing");
        }
    }

    void pass(aiMaterialProperty &property)
    {
        values(property.mKey, property.mSemantic, property.mIndex, property.mType);
        list(property.mData, property.mDataLength);
        // Assimp reads texts by the length that stands before them.
        if (property.mType != aiPTI_String)
            return;
        ai_uint32 length = 0;
        if (property.mDataLength > sizeof length)
            std::memcpy(&length, property.mData, sizeof length);
        if (property.mDataLength <= sizeof length || length >= MAXLEN ||
            property.mDataLength != sizeof length + length + 1 ||
            property.mData[property.mDataLength - 1] != '\0')
            throw std::runtime_error("a material's text is damaged");
    }

    void pass(aiTexture &texture)
    {
        values(texture.mFilename, texture.mWidth, texture.mHeight, texture.achFormatHint);
        texture.achFormatHint[HINTMAXTEXTURELEN - 1] = '\0';
        // Height 0: the bytes of a picture file, as many as the width says.
        if (!present(texture.pcData))
            return;
        const std::uint64_t size =
            std::uint64_t(texture.mWidth) *
            (texture.mHeight > 0 ? std::uint64_t(texture.mHeight) * sizeof(aiTexel) : std::uint64_t(1));
        mArchive.allocate(texture.pcData, (size + sizeof(aiTexel) - 1) / sizeof(aiTexel));
        mArchive.bytes(texture.pcData, size);
    }

    void pass(aiAnimation &animation)
    {
        values(animation.mName, animation.mDuration, animation.mTicksPerSecond);
        objects(animation.mChannels, animation.mNumChannels);
        objects(animation.mMeshChannels, animation.mNumMeshChannels);
        objects(animation.mMorphMeshChannels, animation.mNumMorphMeshChannels);
        if (std::count(animation.mChannels, animation.mChannels + animation.mNumChannels, nullptr) > 0)
            throw std::runtime_error("an animation's channel is missing");
    }

    void pass(aiNodeAnim &channel)
    {
        values(channel.mNodeName, channel.mPreState, channel.mPostState);
        list(channel.mPositionKeys, channel.mNumPositionKeys);
        list(channel.mRotationKeys, channel.mNumRotationKeys);
        list(channel.mScalingKeys, channel.mNumScalingKeys);
    }

    void pass(aiMeshAnim &channel)
    {
        pass(channel.mName);
        list(channel.mKeys, channel.mNumKeys);
    }

    void pass(aiMeshMorphAnim &channel)
    {
        pass(channel.mName);
        list(channel.mKeys, channel.mNumKeys);
    }

    void pass(aiMeshMorphKey &key)
    {
        unsigned count = key.mValues && key.mWeights ? key.mNumValuesAndWeights : 0;
        values(key.mTime, count);
        if (count == 0)
            return;
        mArchive.allocate(key.mValues, count);
        key.mNumValuesAndWeights = count;
        mArchive.allocate(key.mWeights, count);
        mArchive.bytes(key.mValues, count * sizeof *key.mValues);
        mArchive.bytes(key.mWeights, count * sizeof *key.mWeights);
    }

    void pass(aiLight &light)
    {
        values(light.mName, light.mType, light.mPosition, light.mDirection, light.mUp,
               light.mAttenuationConstant, light.mAttenuationLinear, light.mAttenuationQuadratic,
               light.mColorDiffuse, light.mColorSpecular, light.mColorAmbient, light.mAngleInnerCone,
               light.mAngleOuterCone, light.mSize);
    }

    void pass(aiCamera &camera)
    {
        values(camera.mName, camera.mPosition, camera.mUp, camera.mLookAt, camera.mHorizontalFOV,
               camera.mClipPlaneNear, camera.mClipPlaneFar, camera.mAspect, camera.mOrthographicWidth);
    }

    //! Counts how deep the recursion is.
    class Level
    {
    public:
        explicit Level(int &depth) : mDepth(depth)
        {
            if (mDepth > maxDepth)
                throw std::runtime_error("the nodes are nested too deeply");
            ++mDepth;
        }
        ~Level() { --mDepth; }
        Level(const Level &) = delete;
        Level &operator=(const Level &) = delete;

    private:
        int &mDepth;
    };

    Archive &mArchive;
    int mDepth = 0;
};

} // namespace

void writeAssimpScene(aiScene &scene, std::FILE *file)
{
    Output output(file);
    Transfer<Output>(output).pass(scene);
    if (std::fflush(file) != 0)
        throw std::runtime_error("the scene cannot be passed on");
}

std::unique_ptr<aiScene> readAssimpScene(std::span<const char> bytes, std::size_t memory)
{
    Input input(bytes, memory);
    auto scene = std::make_unique<aiScene>();
    Transfer<Input>(input).pass(*scene);
    if (!input.atEnd())
        throw std::runtime_error("there is more than a scene");
    return scene;
}

} // namespace autocuts
