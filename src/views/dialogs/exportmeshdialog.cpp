#include "views/dialogs/exportmeshdialog.h"

#include "model/io/meshes/exportlosses.h"
#include "model/io/meshes/meshfile.h"
#include "views/dialogs/pathfield.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

namespace autocuts {

namespace {

QString formatName(const QString &suffix)
{
    const QString dotted = QStringLiteral(" (.%1)").arg(suffix);
    if (suffix == QLatin1String("obj"))
        return ExportMeshDialog::tr("Wavefront OBJ") + dotted;
    if (suffix == QLatin1String("glb"))
        return ExportMeshDialog::tr("glTF binary") + dotted;
    if (suffix == QLatin1String("gltf"))
        return ExportMeshDialog::tr("glTF with embedded data") + dotted;
    if (suffix == QLatin1String("dae"))
        return ExportMeshDialog::tr("Collada") + dotted;
    if (suffix == QLatin1String("fbx"))
        return ExportMeshDialog::tr("FBX") + dotted;
    if (suffix == QLatin1String("ply"))
        return ExportMeshDialog::tr("Stanford PLY") + dotted;
    return suffix.toUpper() + dotted;
}

QString filterOf(const QString &suffix)
{
    QString filter = formatName(suffix);
    filter.replace(QStringLiteral("(."), QStringLiteral("(*."));
    return filter;
}

//! Names such as glTF keep their lower-case first letter.
QString capitalized(const QString &text)
{
    const QString word = text.section(QLatin1Char(' '), 0, 0);
    return word == word.toLower() ? text.left(1).toUpper() + text.mid(1) : text;
}

} // namespace

ExportMeshDialog::ExportMeshDialog(Scene scene, const QString &path, Questions &questions)
    : QDialog(questions.window()), mScene(std::move(scene)), mFormat(new QComboBox),
      mPath(new PathField(tr("Export mesh"), questions)), mLosses(new QLabel), mProblem(new QLabel)
{
    setWindowTitle(tr("Export mesh"));
    for (const QString &suffix : writableFormats())
        mFormat->addItem(formatName(suffix), suffix);
    mLosses->setWordWrap(true);
    mLosses->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    mLosses->setMinimumHeight(5 * fontMetrics().lineSpacing());
    auto *group = new QGroupBox(tr("What this format cannot hold"));
    (new QVBoxLayout(group))->addWidget(mLosses);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mExport = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    mExport->setDefault(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Format:"), mFormat);
    form->addRow(tr("F&ile:"), mPath);
    form->addRow(QString(), mProblem);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(group, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportMeshDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportMeshDialog::reject);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &ExportMeshDialog::showFormat);
    connect(mPath, &PathField::pathChanged, this, &ExportMeshDialog::showPath);

    const QString format = formatToWrite(mScene.format);
    QString proposed = path + QLatin1Char('.') + format;
    // The suggested path must not be that of the original model, so that it is not replaced by accident.
    if (QFileInfo(proposed) == QFileInfo(mScene.path))
        proposed = path + QStringLiteral("_uv.") + format;
    mPath->setPath(proposed);
    setFormat(format);
    showFormat();
    resize(std::max(560, sizeHint().width()), sizeHint().height());
}

QString ExportMeshDialog::path() const
{
    return mPath->path();
}

QString ExportMeshDialog::format() const
{
    return mFormat->currentData().toString();
}

void ExportMeshDialog::setFormat(const QString &format)
{
    mFormat->setCurrentIndex(mFormat->findData(format));
}

QStringList ExportMeshDialog::losses() const
{
    return exportLosses(mScene, format());
}

void ExportMeshDialog::showFormat()
{
    QString text;
    for (const QString &loss : losses()) {
        text +=
            QStringLiteral("<li style='margin-bottom:4px'>%1</li>").arg(capitalized(loss).toHtmlEscaped());
    }
    mLosses->setText(text.isEmpty() ? tr("Nothing is lost.")
                                    : QStringLiteral("<ul style='margin-left:-22px'>%1</ul>").arg(text));
    mPath->setFilters({filterOf(format())});
    mPath->setSuffix(format());
    showPath();
}

//! A typed suffix sets the format.
void ExportMeshDialog::showPath()
{
    const int index = mFormat->findData(QFileInfo(path()).suffix().toLower());
    QString problem = mPath->problem();
    if (problem.isEmpty() && index < 0)
        problem = tr("No format has this suffix.");
    if (index >= 0)
        mFormat->setCurrentIndex(index);
    mProblem->setText(problem);
    disableFor(problem, mExport);
}

void ExportMeshDialog::accept()
{
    if (mExport->isEnabled() && mPath->confirmReplacing())
        QDialog::accept();
}

} // namespace autocuts
