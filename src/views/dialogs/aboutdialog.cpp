#include "views/dialogs/aboutdialog.h"

#include "views/ui/icons.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace autocuts {

namespace {

struct Library
{
    const char *name;
    const char *licence;
    const char *use;
};

constexpr Library libraries[] = {
    {"Qt", "LGPL-3.0", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "window and drawing")},
    {"Eigen", "MPL-2.0", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "linear algebra")},
    {"OpenBLAS", "BSD-3-Clause", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "dense linear algebra")},
    {"SuiteSparse CHOLMOD", "LGPL-2.1, GPL-2.0", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "sparse solver")},
    {"Assimp", "BSD-3-Clause", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "mesh formats besides OBJ")},
    {"zlib", "Zlib", QT_TRANSLATE_NOOP("autocuts::AboutDialog", "compression of sessions")},
};

QString libraryTable()
{
    QString rows;
    for (const Library &library : libraries)
        rows += QStringLiteral("<tr><td>%1</td><td style='padding-left:16px'>%2</td>"
                               "<td style='padding-left:16px'>%3</td></tr>")
                    .arg(QLatin1String(library.name), AboutDialog::tr(library.use),
                         QLatin1String(library.licence));
    return QStringLiteral("<table cellspacing='3' style='margin-top:8px; white-space:nowrap'>%1</table>")
        .arg(rows);
}

QString aboutText()
{
    const QString version = QCoreApplication::applicationVersion();
    return QStringLiteral("<h2>Autocuts %1</h2><p>%2</p><p>%3</p><p>%4</p>%5")
        .arg(version, AboutDialog::tr("UV maps with distortion and cuts optimised together."),
             AboutDialog::tr(
                 "After <i>Autocuts: Simultaneous Distortion and Cut Optimization for UV Mapping</i> "
                 "by R. Poranne, M. Tarini, S. Huber, D. Panozzo and O. Sorkine-Hornung, "
                 "SIGGRAPH Asia 2017."),
             AboutDialog::tr(
                 "Free software under the "
                 "<a href='https://www.gnu.org/licenses/gpl-3.0.html'>GNU General Public License</a>, "
                 "version 3 or later. It comes without any warranty."),
             libraryTable());
}

} // namespace

AboutDialog::AboutDialog(QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("About Autocuts"));
    auto *picture = new QLabel;
    picture->setPixmap(applicationIcon().pixmap(QSize(96, 96), devicePixelRatioF()));
    picture->setAlignment(Qt::AlignTop);
    auto *text = new QLabel(aboutText());
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setOpenExternalLinks(true);
    text->setTextInteractionFlags(Qt::TextBrowserInteraction);
    text->setMinimumWidth(440);
    auto *row = new QHBoxLayout;
    row->setSpacing(20);
    row->addWidget(picture);
    row->addWidget(text, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &AboutDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row);
    layout->addWidget(buttons);
}

} // namespace autocuts
