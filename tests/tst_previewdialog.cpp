// The preview of textures on the model.
#include "support/gridstudio.h"
#include "views/canvas/meshview.h"
#include "views/dialogs/previewdialog.h"

#include <QComboBox>
#include <QPushButton>

namespace tst_previewdialog {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::GridStudio;

class TestPreviewDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesHaveTheSizeChosen()
    {
        GridStudio studio;
        const DocumentState before = studio.document().state();
        const ViewOptions options = studio.view.options();
        PreviewDialog dialog(studio.context, studio.answers);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QCOMPARE(dialog.options().pattern, Pattern::Checker);
        QCOMPARE(dialog.options().checkerSize, 2048.0 / 16);
        const QImage checker = dialog.view().picture();
        choose(dialog, "size", 256);
        QCOMPARE(dialog.options().checkerSize, 256.0 / 16);
        QVERIFY(dialog.view().picture() != checker);

        choose(dialog, "picture", int(PreviewDialog::Picture::Layout));
        QVERIFY(showsTexture(dialog));
        QCOMPARE(QImage(dialog.options().texturePath).size(), QSize(256, 256));
        choose(dialog, "size", 512);
        QVERIFY(showsTexture(dialog));
        QCOMPARE(QImage(dialog.options().texturePath).size(), QSize(512, 512));

        const QString path = studio.path("Текстура.png");
        QVERIFY(QImage(30, 20, QImage::Format_RGB32).save(path));
        studio.answers.filesToOpen = {path};
        choose(dialog, "picture", int(PreviewDialog::Picture::Texture));
        QVERIFY(showsTexture(dialog));
        QCOMPARE(QImage(dialog.options().texturePath).size(), QSize(512, 512));
        QVERIFY(studio.document().state() == before);
        QVERIFY(studio.view.options() == options);
    }

    void badTexturesAreTold()
    {
        GridStudio studio;
        PreviewDialog dialog(studio.context, studio.answers);
        // Cancelled: the checkerboard stays.
        choose(dialog, "picture", int(PreviewDialog::Picture::Texture));
        QCOMPARE(dialog.findChild<QComboBox *>(u"picture"_s)->currentIndex(), 0);
        studio.answers.filesToOpen = {studio.path("missing.png")};
        choose(dialog, "picture", int(PreviewDialog::Picture::Texture));
        QVERIFY(QTest::qWaitFor([&] { return dialog.isReady(); }, 60'000));
        QCOMPARE(dialog.options().pattern, Pattern::Checker);
    }

    void thePictureIsSaved()
    {
        GridStudio studio;
        const QString path = studio.path("view.png");
        bool shown = false;
        studio.answers.onDialog = [&](QDialog &dialog) {
            shown = qobject_cast<PreviewDialog *>(&dialog) != nullptr;
            dialog.show();
            studio.answers.filesToSave = {path};
            for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
                if (button->text().remove(u'&') == u"Save picture..."_s)
                    button->click();
            }
            return 0;
        };
        studio.trigger("view.preview");
        QVERIFY(shown);
        QTRY_VERIFY_WITH_TIMEOUT(!studio.context.files.jobs().isBusy(), 60'000);
        QVERIFY(!QImage(path).isNull());
        QVERIFY(studio.answers.errors.isEmpty());
    }

private:
    static void choose(PreviewDialog &dialog, const char *name, int data)
    {
        auto *combo = dialog.findChild<QComboBox *>(QString::fromLatin1(name));
        combo->setCurrentIndex(combo->findData(data));
        Q_EMIT combo->activated(combo->currentIndex());
    }
    static bool showsTexture(const PreviewDialog &dialog)
    {
        return QTest::qWaitFor([&] { return dialog.isReady(); }, 60'000) &&
               dialog.options().pattern == Pattern::Texture;
    }
};

QTEST_MAIN(TestPreviewDialog)

} // namespace tst_previewdialog

#include "tst_previewdialog.moc"
