#include "model/io/collada/colladamesh.h"
#include "model/io/collada/colladasource.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>

namespace autocuts {

namespace {

//! One line of a <source>: the UV and what the old one has besides.
using Row = std::vector<double>;

//! Numbers the rows, equal ones once.
class RowTable
{
public:
    int numberOf(const Row &row)
    {
        const auto [place, isNew] = mNumbers.try_emplace(row, static_cast<int>(mRows.size()));
        if (isNew)
            mRows.push_back(&place->first);
        return place->second;
    }
    const std::vector<const Row *> &rows() const { return mRows; }
    //! The numbers, with spaces between them.
    std::string text() const;

private:
    std::map<Row, int> mNumbers;
    std::vector<const Row *> mRows;
};

std::string RowTable::text() const
{
    std::string text;
    char word[40];
    for (const Row *row : mRows) {
        for (const double value : *row) {
            if (!text.empty())
                text += ' ';
            text.append(word, std::to_chars(word, word + sizeof word, value).ptr);
        }
    }
    return text;
}

//! The UVs of one set of a primitive.
struct NewUvs
{
    const UvMatrix *uv = nullptr;
    std::vector<int> sceneCorner; //!< of each corner of the primitive, -1 for none
};

//! Rewrites one primitive: the same words, but for some columns, and perhaps more of them.
class CornerEdits
{
public:
    explicit CornerEdits(const ColladaPrimitive &primitive) : mPrimitive(primitive) {}

    void replace(int column, std::vector<int> indices) { mReplaced[column] = std::move(indices); }
    //! \returns the offset of the new column
    int add(std::vector<int> indices)
    {
        mAdded.push_back(std::move(indices));
        return mPrimitive.stride + static_cast<int>(mAdded.size()) - 1;
    }
    void appendTo(std::vector<TextEdit> &edits) const;

private:
    const ColladaPrimitive &mPrimitive;
    std::map<int, std::vector<int>> mReplaced;
    std::vector<std::vector<int>> mAdded;
};

void CornerEdits::appendTo(std::vector<TextEdit> &edits) const
{
    for (int c = 0; c < mPrimitive.cornerCount(); ++c) {
        const auto corner = static_cast<std::size_t>(c);
        for (const auto &[column, indices] : mReplaced) {
            const std::string_view word =
                mPrimitive.words[static_cast<std::size_t>(c) * mPrimitive.stride + column];
            edits.push_back({word.data(), word.data() + word.size(), std::to_string(indices[corner])});
        }
        const std::string_view last =
            mPrimitive.words[static_cast<std::size_t>((c + 1) * mPrimitive.stride - 1)];
        for (const std::vector<int> &indices : mAdded)
            edits.push_back({last.data() + last.size(), last.data() + last.size(),
                             ' ' + std::to_string(indices[corner])});
    }
}

class ColladaRewriter
{
public:
    ColladaRewriter(const ColladaSource &source, const Scene &scene)
        : mSource(source), mScene(scene),
          mText(source.bytes.constData(), static_cast<std::size_t>(source.bytes.size())),
          mFile(*readCollada(mText))
    {}

    QByteArray run();

private:
    std::vector<const UvSet *> setsInOrder() const;
    void rewriteGeometry(std::size_t geometry);
    //! What the primitive gets in a set; nothing when that is what it has.
    std::optional<NewUvs> newUvs(std::size_t geometry, std::size_t primitive, std::size_t channel) const;
    void rewriteSet(std::size_t geometry, int set, const std::map<std::size_t, NewUvs> &changed);
    std::vector<int> rowNumbers(const ColladaPrimitive &primitive, const ColladaInput *input,
                                const NewUvs *uvs, std::size_t columns, RowTable &table) const;
    bool canReplace(const ColladaGeometry &geometry, const ColladaInput &input, int set) const;
    void replaceSource(const ColladaNumbers &numbers, const RowTable &table);
    std::string addSource(std::size_t geometry, int set, const RowTable &table);
    void setInput(const ColladaPrimitive &primitive, const ColladaInput *input, int set,
                  const std::string &id, std::optional<int> offset);
    void setAttribute(const XmlElement &element, std::string_view name, const std::string &value);

    const ColladaSource &mSource;
    const Scene &mScene;
    std::string_view mText;
    ColladaFile mFile;
    std::vector<const UvSet *> mSets; //!< by the number that Assimp gives them
    std::vector<TextEdit> mEdits;
    std::map<const ColladaPrimitive *, CornerEdits> mCorners;
};

//! The UV sets by their names; renamed and new ones take what is left, then new numbers.
std::vector<const UvSet *> ColladaRewriter::setsInOrder() const
{
    std::vector<const UvSet *> sets(mSource.setsInFile.size(), nullptr), others;
    for (const UvSet &set : mScene.uvSets) {
        const auto known = std::find_if(mSource.setsInFile.begin(), mSource.setsInFile.end(),
                                        [&](const UvSet &old) { return old.name == set.name; });
        const auto place = static_cast<std::size_t>(known - mSource.setsInFile.begin());
        if (known == mSource.setsInFile.end() || sets[place])
            others.push_back(&set);
        else
            sets[place] = &set;
    }
    for (const UvSet *other : others) {
        const auto free = std::find(sets.begin(), sets.end(), nullptr);
        if (free == sets.end())
            sets.push_back(other);
        else
            *free = other;
    }
    return sets;
}

std::optional<NewUvs> ColladaRewriter::newUvs(std::size_t geometry, std::size_t primitive,
                                              std::size_t channel) const
{
    const UvSet *set = mSets[channel];
    const auto piece =
        std::find_if(mSource.places.begin(), mSource.places.end(), [&](const ColladaPlace &place) {
            return place.geometry == geometry && place.primitive == primitive;
        });
    if (!set || piece == mSource.places.end())
        return {};
    const ColladaPrimitive &from = mFile.geometries[geometry].primitives[primitive];
    const AssimpPiece &soup = mSource.pieces[static_cast<std::size_t>(piece - mSource.places.begin())];
    const UvMatrix *old = channel < mSource.setsInFile.size() ? &mSource.setsInFile[channel].uv : nullptr;
    NewUvs result{&set->uv, {}};
    bool isChanged = false;
    int number = 0;
    for (const int size : from.faceSizes) {
        for (int k = 0; k < size; ++k) {
            const int corner = size < 3 ? -1 : pieceCorner(*mScene.mesh, soup, number++);
            result.sceneCorner.push_back(corner);
            if (corner >= 0 && set->uv.row(corner).allFinite())
                isChanged |= !old || !sameBits(set->uv.row(corner), old->row(corner));
        }
    }
    return isChanged ? std::optional(result) : std::nullopt;
}

//! The row of each corner: the new UV, or the old one where there is none.
std::vector<int> ColladaRewriter::rowNumbers(const ColladaPrimitive &primitive, const ColladaInput *input,
                                             const NewUvs *uvs, std::size_t columns, RowTable &table) const
{
    std::vector<int> numbers;
    const ColladaNumbers *old = input ? &mFile.sources.at(input->source) : nullptr;
    for (int c = 0; c < primitive.cornerCount(); ++c) {
        Row row(columns, 0.0);
        if (old) {
            const int index =
                primitive.indices[static_cast<std::size_t>(c) * primitive.stride + input->offset];
            const double *values = old->values.data() + static_cast<std::ptrdiff_t>(index) * old->stride;
            std::copy_n(values, std::min(columns, static_cast<std::size_t>(old->stride)), row.begin());
        }
        const int corner = uvs ? uvs->sceneCorner[static_cast<std::size_t>(c)] : -1;
        if (corner >= 0 && uvs->uv->row(corner).allFinite()) {
            row[0] = (*uvs->uv)(corner, 0);
            row[1] = (*uvs->uv)(corner, 1);
        }
        numbers.push_back(table.numberOf(row));
    }
    return numbers;
}

//! True when nothing but this set of this geometry uses the source.
bool ColladaRewriter::canReplace(const ColladaGeometry &geometry, const ColladaInput &input, int set) const
{
    std::size_t ours = 0, all = 0;
    for (const ColladaPrimitive &primitive : geometry.primitives) {
        const ColladaInput *other = primitive.texcoord(set);
        ours += other && other->source == input.source;
    }
    if (input.inVertices)
        ours = 1;
    for (const char quote : {'"', '\''}) {
        const std::string reference = '#' + std::string(input.source) + quote;
        for (std::size_t at = mText.find(reference); at != std::string_view::npos;
             at = mText.find(reference, at + 1))
            ++all;
    }
    return ours == all && mFile.sources.at(input.source).isPlain;
}

void ColladaRewriter::setAttribute(const XmlElement &element, std::string_view name, const std::string &value)
{
    const std::string_view old = element.attribute(name);
    if (old.data()) {
        mEdits.push_back({old.data(), old.data() + old.size(), value});
        return;
    }
    const char *place = element.whole.data() + 1 +
                        mText.substr(static_cast<std::size_t>(element.whole.data() + 1 - mText.data()))
                            .find_first_of(" \t\r\n/>");
    mEdits.push_back({place, place, ' ' + std::string(name) + "=\"" + value + '"'});
}

void ColladaRewriter::replaceSource(const ColladaNumbers &numbers, const RowTable &table)
{
    const std::string_view content = numbers.array->content;
    mEdits.push_back({content.data(), content.data() + content.size(), table.text()});
    setAttribute(*numbers.array, "count",
                 std::to_string(table.rows().size() * static_cast<std::size_t>(numbers.stride)));
    setAttribute(*numbers.accessor, "count", std::to_string(table.rows().size()));
}

std::string ColladaRewriter::addSource(std::size_t geometry, int set, const RowTable &table)
{
    std::string id = "autocuts-uv-" + std::to_string(geometry) + '-' + std::to_string(set);
    while (mText.find(id) != std::string_view::npos)
        id += '-';
    const std::string rows = std::to_string(table.rows().size());
    const std::string source = "<source id=\"" + id + "\"><float_array id=\"" + id + "-array\" count=\"" +
                               std::to_string(2 * table.rows().size()) + "\">" + table.text() +
                               "</float_array><technique_common><accessor source=\"#" + id +
                               "-array\" count=\"" + rows +
                               "\" stride=\"2\"><param name=\"S\" type=\"float\"/>" +
                               "<param name=\"T\" type=\"float\"/></accessor></technique_common></source>\n";
    const char *place = mFile.geometries[geometry].vertices->whole.data();
    mEdits.push_back({place, place, source});
    return id;
}

//! Changes the input of a primitive, or adds one behind the last. \param offset nothing: it stays
void ColladaRewriter::setInput(const ColladaPrimitive &primitive, const ColladaInput *input, int set,
                               const std::string &id, std::optional<int> offset)
{
    if (!input || input->inVertices) {
        const auto own = std::find_if(primitive.inputs.rbegin(), primitive.inputs.rend(),
                                      [](const ColladaInput &other) { return !other.inVertices; });
        const std::string_view last = own->element->whole;
        mEdits.push_back({last.data() + last.size(), last.data() + last.size(),
                          "<input semantic=\"TEXCOORD\" source=\"#" + id + "\" offset=\"" +
                              std::to_string(*offset) + "\" set=\"" + std::to_string(set) + "\"/>"});
        return;
    }
    setAttribute(*input->element, "source", '#' + id);
    if (offset)
        setAttribute(*input->element, "offset", std::to_string(*offset));
}

void ColladaRewriter::rewriteSet(std::size_t number, int set, const std::map<std::size_t, NewUvs> &changed)
{
    const ColladaGeometry &geometry = mFile.geometries[number];
    const ColladaInput *first = geometry.primitives[changed.begin()->first].texcoord(set);
    const bool inPlace = first && canReplace(geometry, *first, set);
    const std::size_t columns =
        inPlace ? static_cast<std::size_t>(mFile.sources.at(first->source).stride) : 2;
    RowTable table;
    std::map<std::size_t, std::vector<int>> rows;
    for (std::size_t p = 0; p < geometry.primitives.size(); ++p) {
        const ColladaPrimitive &primitive = geometry.primitives[p];
        const ColladaInput *input = primitive.texcoord(set);
        const auto uvs = changed.find(p);
        const bool shares =
            first && (inPlace || first->inVertices) && input && input->source == first->source;
        if (uvs != changed.end() || shares)
            rows[p] =
                rowNumbers(primitive, input, uvs == changed.end() ? nullptr : &uvs->second, columns, table);
    }
    std::string id;
    if (inPlace)
        replaceSource(mFile.sources.at(first->source), table);
    else
        id = addSource(number, set, table);
    if (first && first->inVertices) {
        const std::string_view old = first->element->whole;
        mEdits.push_back({old.data(), old.data() + old.size(), {}});
    }
    for (auto &[p, indices] : rows) {
        const ColladaPrimitive &primitive = geometry.primitives[p];
        const ColladaInput *input = primitive.texcoord(set);
        const auto sharesOffset = [&](const ColladaInput &other) {
            return &other != input && other.offset == input->offset;
        };
        CornerEdits &corners = mCorners.try_emplace(&primitive, primitive).first->second;
        std::optional<int> offset;
        if (!input || std::any_of(primitive.inputs.begin(), primitive.inputs.end(), sharesOffset))
            offset = corners.add(std::move(indices));
        else
            corners.replace(input->offset, std::move(indices));
        setInput(primitive, input, set, inPlace ? std::string(first->source) : id, offset);
    }
}

//! The set numbers below maxAssimpUvSets that no primitive has: first those behind the others, then those
//! between them.
std::vector<int> freeSets(const ColladaGeometry &geometry)
{
    std::set<int> used;
    for (const ColladaPrimitive &primitive : geometry.primitives) {
        for (const ColladaInput &input : primitive.inputs) {
            if (input.semantic == "TEXCOORD")
                used.insert(input.set);
        }
    }
    const int behind = used.empty() ? 0 : *used.rbegin() + 1;
    std::vector<int> free;
    for (int n = 0; n < maxAssimpUvSets; ++n) {
        const int set = (behind + n) % maxAssimpUvSets;
        if (!used.contains(set))
            free.push_back(set);
    }
    return free;
}

void ColladaRewriter::rewriteGeometry(std::size_t number)
{
    const ColladaGeometry &geometry = mFile.geometries[number];
    const std::vector<int> free = freeSets(geometry);
    std::map<int, std::map<std::size_t, NewUvs>> bySet;
    for (std::size_t p = 0; p < geometry.primitives.size(); ++p) {
        const std::vector<int> sets = geometry.setsOf(p);
        const std::size_t count = std::min(mSets.size(), sets.size() + free.size());
        for (std::size_t channel = 0; channel < count; ++channel) {
            const int set = channel < sets.size() ? sets[channel] : free[channel - sets.size()];
            if (std::optional<NewUvs> uvs = newUvs(number, p, channel))
                bySet[set][p] = std::move(*uvs);
        }
    }
    for (const auto &[set, changed] : bySet)
        rewriteSet(number, set, changed);
}

QByteArray ColladaRewriter::run()
{
    mSets = setsInOrder();
    for (std::size_t g = 0; g < mFile.geometries.size(); ++g)
        rewriteGeometry(g);
    for (const auto &[primitive, corners] : mCorners)
        corners.appendTo(mEdits);
    return mEdits.empty() ? mSource.bytes : QByteArray::fromStdString(edited(mText, std::move(mEdits)));
}

} // namespace

QByteArray rewriteCollada(const ColladaSource &source, const Scene &scene)
{
    return ColladaRewriter(source, scene).run();
}

} // namespace autocuts
