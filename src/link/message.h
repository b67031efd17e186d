// One message of the live link: fields as JSON and arrays of numbers. docs/link.md describes the bytes.
#pragma once

#include "model/document/result.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>

#include <span>
#include <vector>

namespace autocuts::link {

//! Number of the protocol: a studio and a program with different ones do not talk.
inline constexpr int protocolVersion = 1;

//! The two numbers at the beginning of a frame: bytes of the fields and bytes of the arrays, each 32 bits,
//! low byte first.
inline constexpr qsizetype frameHeadSize = 8;

//! The contents of a frame. An array has rows of equally many numbers, 32-bit integers or floats of 32 or 64
//! bits.
class Message
{
public:
    Message() = default;
    explicit Message(const QString &type) : mType(type) {}
    //! \param fields the JSON text of a frame \param arrays the bytes after it
    //! \returns an Error when the text is no object with a type, or the arrays do not fit it
    static Result<Message> decode(const QByteArray &fields, const QByteArray &arrays);

    const QString &type() const { return mType; }
    const QJsonObject &fields() const { return mFields; }
    void set(const QString &name, const QJsonValue &value) { mFields.insert(name, value); }

    bool has(const QString &array) const { return find(array) != nullptr; }
    //! Appends an array. \pre the values are whole rows
    void add(const QString &name, std::span<const int> values, int columns = 1);
    void add(const QString &name, std::span<const double> values, int columns = 1);
    //! The values of an array, row by row; none when it is missing.
    //! \returns an Error when it is not of whole numbers or has other columns
    Result<std::vector<int>> integers(const QString &name, int columns = 1) const;
    //! The same of floating point numbers.
    Result<std::vector<double>> numbers(const QString &name, int columns = 1) const;

    //! The bytes of the frame.
    QByteArray encoded() const;

private:
    enum class Kind { Int32, Float32, Float64 };
    struct Array
    {
        QString name;
        Kind kind = Kind::Int32;
        qsizetype rows = 0, columns = 1;
        qsizetype offset = 0; //!< of its first byte in mBytes

        qsizetype count() const { return rows * columns; }
        qsizetype bytes() const { return count() * (kind == Kind::Float64 ? 8 : 4); }
    };

    const Array *find(const QString &name) const;
    Result<Done> takeArrays(const QJsonValue &described);
    static Result<Array> readArray(const QJsonValue &described);
    template <class T>
    void append(const QString &name, Kind kind, std::span<const T> values, int columns);

    QString mType;
    QJsonObject mFields; //!< without type and arrays
    std::vector<Array> mArrays;
    QByteArray mBytes;
};

//! An Error about what came over the link. \param message one line
Error linkError(const QString &message);
//! That the studio has another model than the one that a message is about.
Error otherModel();

} // namespace autocuts::link
