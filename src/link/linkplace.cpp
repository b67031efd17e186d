#include "link/linkplace.h"

#include "link/message.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>
#include <array>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto ownerOnly = QFileDevice::ReadOwner | QFileDevice::WriteOwner;

} // namespace

QString LinkPlace::userFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) + u"/autocuts"_s;
}

QString LinkPlace::path(QLatin1StringView suffix) const
{
    return u"%1/studio-%2.%3"_s.arg(folder).arg(process).arg(suffix);
}

Result<Done> LinkPlace::prepare() const
{
    const auto forUser = ownerOnly | QFileDevice::ExeOwner;
    if (!QDir().mkpath(folder) || !QFile::setPermissions(folder, forUser))
        return Error{u"The folder of the live link cannot be made for this user only"_s, folder, 0,
                     u"Set XDG_RUNTIME_DIR to a folder of your own"_s};
    remove();
    return Done();
}

Result<Done> LinkPlace::write(const QByteArray &token, const QString &model) const
{
    const QJsonObject place{{"version"_L1, protocolVersion},
                            {"socket"_L1, socket()},
                            {"token"_L1, QString::fromLatin1(token)},
                            {"process"_L1, process},
                            {"model"_L1, model}};
    QSaveFile out(file());
    // The file is not readable by others at any time: its folder is not, and the rights are set while it is
    // empty.
    if (!out.open(QIODevice::WriteOnly) || !out.setPermissions(ownerOnly) ||
        out.write(QJsonDocument(place).toJson()) < 0 || !out.commit())
        return Error{out.errorString(), file(), 0, u"Other programs cannot find this studio"_s};
    return Done();
}

void LinkPlace::remove() const
{
    QFile::remove(file());
    QFile::remove(socket());
}

QByteArray newToken()
{
    std::array<quint32, 8> bits;
    QRandomGenerator::system()->fillRange(bits.data(), qsizetype(bits.size()));
    return QByteArray(reinterpret_cast<const char *>(bits.data()), sizeof bits).toHex();
}

bool sameToken(const QByteArray &a, const QByteArray &b)
{
    int differences = a.size() != b.size();
    for (qsizetype i = 0; i < std::min(a.size(), b.size()); ++i)
        differences |= a[i] ^ b[i];
    return differences == 0;
}

} // namespace autocuts::link
