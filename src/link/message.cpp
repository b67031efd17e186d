#include "link/message.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <limits>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype mostArrays = 64; // chosen by hand
constexpr auto typeField = "type"_L1, arraysField = "arrays"_L1;
constexpr std::array<QLatin1StringView, 3> kindNames{"i4"_L1, "f4"_L1, "f8"_L1};

//! A number of rows or columns; -1 when it is none.
qsizetype countOf(const QJsonValue &value)
{
    const qint64 count = value.toInteger(-1);
    return count >= 0 && count <= std::numeric_limits<int>::max() ? qsizetype(count) : -1;
}

QString noArray(const QString &name)
{
    return u"the array \"%1\" is not described well"_s.arg(name);
}

} // namespace

Error linkError(const QString &message)
{
    return {message, {}, 0, u"Use programs of the same version (docs/link.md)"_s};
}

Error otherModel()
{
    return {u"the studio has another model"_s, {}, 0, u"Open this one in Autocuts again"_s};
}

Result<Message> Message::decode(const QByteArray &fields, const QByteArray &arrays)
{
    const QJsonDocument document = QJsonDocument::fromJson(fields);
    Message message(document.object().value(typeField).toString());
    if (message.mType.isEmpty())
        return linkError(u"a message has no fields that can be read"_s);
    message.mFields = document.object();
    message.mFields.remove(typeField);
    message.mBytes = arrays;
    if (const Result<Done> taken = message.takeArrays(message.mFields.take(arraysField)); !taken)
        return taken.error();
    return message;
}

Result<Done> Message::takeArrays(const QJsonValue &described)
{
    const QJsonArray list = described.toArray();
    if (list.size() > mostArrays)
        return linkError(u"a message has %1 arrays"_s.arg(list.size()));
    qsizetype offset = 0;
    for (const QJsonValue &one : list) {
        Result<Array> array = readArray(one);
        if (!array)
            return array.error();
        if (has(array->name))
            return linkError(noArray(array->name));
        array->offset = offset;
        offset += array->bytes();
        mArrays.push_back(std::move(array).value());
    }
    if (offset != mBytes.size())
        return linkError(
            u"the arrays of \"%1\" have %2 bytes in place of %3"_s.arg(mType).arg(mBytes.size()).arg(offset));
    return Done();
}

Result<Message::Array> Message::readArray(const QJsonValue &described)
{
    Array array;
    array.name = described["name"_L1].toString();
    const auto kind = std::ranges::find(kindNames, described["kind"_L1].toString());
    const QJsonArray shape = described["shape"_L1].toArray();
    array.rows = countOf(shape.at(0));
    array.columns = shape.size() > 1 ? countOf(shape.at(1)) : 1;
    const bool fine = shape.size() == 1 || shape.size() == 2;
    if (array.name.isEmpty() || kind == kindNames.end() || !fine || array.rows < 0 || array.columns < 1)
        return linkError(noArray(array.name));
    // No frame is as large, and the number of bytes stays in range.
    if (array.rows > std::numeric_limits<int>::max() / array.columns)
        return linkError(noArray(array.name));
    array.kind = Kind(kind - kindNames.begin());
    return array;
}

const Message::Array *Message::find(const QString &name) const
{
    const auto found = std::ranges::find(mArrays, name, &Array::name);
    return found == mArrays.end() ? nullptr : &*found;
}

template <class T>
void Message::append(const QString &name, Kind kind, std::span<const T> values, int columns)
{
    const Array array{name, kind, qsizetype(values.size()) / columns, columns, mBytes.size()};
    mBytes.resize(array.offset + array.bytes());
    if (array.count() > 0)
        qToLittleEndian<T>(values.data(), array.count(), mBytes.data() + array.offset);
    mArrays.push_back(array);
}

void Message::add(const QString &name, std::span<const int> values, int columns)
{
    append(name, Kind::Int32, values, columns);
}

void Message::add(const QString &name, std::span<const double> values, int columns)
{
    append(name, Kind::Float64, values, columns);
}

Result<std::vector<int>> Message::integers(const QString &name, int columns) const
{
    const Array *array = find(name);
    if (!array)
        return std::vector<int>();
    if (array->kind != Kind::Int32 || array->columns != columns)
        return linkError(u"the array \"%1\" is not of rows of %2 whole numbers"_s.arg(name).arg(columns));
    std::vector<int> values(static_cast<std::size_t>(array->count()));
    if (values.empty())
        return values;
    qFromLittleEndian<int>(mBytes.constData() + array->offset, array->count(), values.data());
    return values;
}

Result<std::vector<double>> Message::numbers(const QString &name, int columns) const
{
    const Array *array = find(name);
    if (!array)
        return std::vector<double>();
    if (array->kind == Kind::Int32 || array->columns != columns)
        return linkError(u"the array \"%1\" is not of rows of %2 numbers"_s.arg(name).arg(columns));
    std::vector<double> values(static_cast<std::size_t>(array->count()));
    if (values.empty())
        return values;
    const char *bytes = mBytes.constData() + array->offset;
    if (array->kind == Kind::Float64) {
        qFromLittleEndian<double>(bytes, array->count(), values.data());
        return values;
    }
    std::vector<float> single(values.size());
    qFromLittleEndian<float>(bytes, array->count(), single.data());
    std::ranges::copy(single, values.begin());
    return values;
}

QByteArray Message::encoded() const
{
    QJsonArray described;
    for (const Array &array : mArrays)
        described << QJsonObject{{"name"_L1, array.name},
                                 {"kind"_L1, kindNames[std::size_t(array.kind)]},
                                 {"shape"_L1, QJsonArray{array.rows, array.columns}}};
    QJsonObject fields = mFields;
    fields.insert(typeField, mType);
    if (!described.isEmpty())
        fields.insert(arraysField, described);
    const QByteArray text = QJsonDocument(fields).toJson(QJsonDocument::Compact);
    QByteArray frame(frameHeadSize, '\0');
    qToLittleEndian(quint32(text.size()), frame.data());
    qToLittleEndian(quint32(mBytes.size()), frame.data() + 4);
    frame.reserve(frameHeadSize + text.size() + mBytes.size());
    return frame += text + mBytes;
}

} // namespace autocuts::link
