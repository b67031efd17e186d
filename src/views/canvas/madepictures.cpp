#include "views/canvas/madepictures.h"

#include "model/pictures/picturereading.h"
#include "views/gl/letteredpattern.h"
#include "views/ui/task.h"

#include <QPointer>

#include <map>
#include <utility>
#include <vector>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

//! Pictures that are being made or are made. Only the GUI thread holds it, as long as a view wants them.
struct MadePictures::Making
{
    Pictures pictures;
    bool ready = false;
    std::vector<QPointer<MadePictures>> waiting;
    Task task;

    static void take(const std::shared_ptr<Making> &making, Pictures pictures)
    {
        making->pictures = std::move(pictures);
        making->ready = true;
        for (const QPointer<MadePictures> &view : std::exchange(making->waiting, {})) {
            if (view && view->mNext == making)
                view->showNext();
        }
    }
};

//! Those with that key; made from now on if nobody has asked for them.
std::shared_ptr<MadePictures::Making> MadePictures::making(const QString &key, const Make &make)
{
    static std::map<QString, std::weak_ptr<Making>> known;
    std::erase_if(known, [](const auto &entry) { return entry.second.expired(); });
    std::weak_ptr<Making> &place = known[key];
    if (std::shared_ptr<Making> same = place.lock())
        return same;
    auto own = std::make_shared<Making>();
    place = own;
    const auto take = [wanted = std::weak_ptr(own)](const Pictures &pictures) {
        Making::take(wanted.lock(), pictures);
    };
    own->task.start(
        [make](const std::atomic<bool> &stop) { return stop ? Pictures() : readyForUpload(make()); }, take,
        [take](const QString &) { take({}); });
    return own;
}

MadePictures::MadePictures(QObject *parent) : QObject(parent) {}

MadePictures::~MadePictures() = default;

const Pictures &MadePictures::pictures() const
{
    static const Pictures none;
    return mShown ? mShown->pictures : none;
}

void MadePictures::ask(const QString &key, const Make &make, bool keep)
{
    if (key == mKey)
        return;
    mKey = key;
    mNext.reset();
    if (!keep || key.isEmpty())
        mShown.reset();
    if (!key.isEmpty()) {
        mNext = making(key, make);
        if (mNext->ready)
            return showNext();
        mNext->waiting.emplace_back(this);
    }
    Q_EMIT changed();
}

void MadePictures::showNext()
{
    mShown = std::exchange(mNext, nullptr);
    Q_EMIT changed();
}

void askForTexture(MadePictures &pictures, const QString &path)
{
    pictures.ask(
        path.isEmpty() ? QString() : u"file "_s + path,
        [path] {
            QStringList problems; // whoever set the path has looked whether there is a picture
            return readPictures({{path, {}, path}}, problems);
        },
        false);
}

void askForLetters(MadePictures &pictures, int cells)
{
    pictures.ask(
        u"letters %1"_s.arg(cells), [cells] { return Pictures::of(letteredPattern(cells)); }, true);
}

} // namespace autocuts
