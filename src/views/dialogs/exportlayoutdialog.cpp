#include "views/dialogs/exportlayoutdialog.h"

#include "views/actions/questions.h"
#include "views/dialogs/pathfield.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace autocuts {

namespace {

// Limits of LayoutOptions::size.
constexpr int minSize = 16, maxSize = 16384;

} // namespace

ExportLayoutDialog::ExportLayoutDialog(int size, const QString &path, std::vector<int> overlapping,
                                       Questions &questions)
    : QDialog(questions.window()), mOverlapping(std::move(overlapping)), mFormat(new QComboBox),
      mBackground(new QComboBox), mSize(new QSpinBox), mEdges(new QCheckBox(tr("&Edges inside the islands"))),
      mOverlaps(new QCheckBox(tr("Hatch &overlaps"))), mPath(new PathField(tr("Export layout"), questions)),
      mProblem(new QLabel)
{
    setWindowTitle(tr("Export layout"));
    mFormat->addItem(tr("PNG, to paint over"), QStringLiteral("png"));
    mFormat->addItem(tr("SVG, to print or edit"), QStringLiteral("svg"));
    mBackground->addItem(tr("Transparent"), int(LayoutBackground::Transparent));
    mBackground->addItem(tr("Dark"), int(LayoutBackground::Dark));
    mBackground->addItem(tr("Light"), int(LayoutBackground::Light));
    const LayoutOptions defaults;
    mBackground->setCurrentIndex(mBackground->findData(int(defaults.background)));
    mSize->setRange(minSize, maxSize);
    mSize->setSuffix(tr(" px"));
    mSize->setValue(std::clamp(size, minSize, maxSize));
    mEdges->setChecked(defaults.edges);
    mOverlaps->setEnabled(!mOverlapping.empty());
    mOverlaps->setChecked(!mOverlapping.empty());
    if (mOverlapping.empty())
        mOverlaps->setToolTip(tr("The map has no overlaps, or was not measured yet"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    mExport = buttons->addButton(tr("E&xport"), QDialogButtonBox::AcceptRole);
    mExport->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(tr("&Format:"), mFormat);
    form->addRow(tr("&Size:"), mSize);
    form->addRow(tr("Back&ground:"), mBackground);
    form->addRow(QString(), mEdges);
    form->addRow(QString(), mOverlaps);
    form->addRow(tr("F&ile:"), mPath);
    form->addRow(QString(), mProblem);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportLayoutDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportLayoutDialog::reject);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &ExportLayoutDialog::showFormat);
    connect(mPath, &PathField::pathChanged, this, &ExportLayoutDialog::showPath);
    mPath->setPath(path);
    showFormat();
}

QString ExportLayoutDialog::path() const
{
    return mPath->path();
}

LayoutOptions ExportLayoutDialog::options() const
{
    LayoutOptions options;
    options.size = mSize->value();
    options.edges = mEdges->isChecked();
    options.background = LayoutBackground(mBackground->currentData().toInt());
    if (mOverlaps->isChecked())
        options.overlapping = mOverlapping;
    return options;
}

void ExportLayoutDialog::showFormat()
{
    const QString suffix = mFormat->currentData().toString();
    mPath->setFilters(
        {suffix == QLatin1String("png") ? tr("PNG picture (*.png)") : tr("SVG drawing (*.svg)")});
    mPath->setSuffix(suffix);
    showPath();
}

//! A suffix that was typed chooses the format.
void ExportLayoutDialog::showPath()
{
    const int index = mFormat->findData(QFileInfo(path()).suffix().toLower());
    QString problem = mPath->problem();
    if (problem.isEmpty() && index < 0)
        problem = tr("The suffix must be .png or .svg.");
    if (index >= 0)
        mFormat->setCurrentIndex(index);
    mProblem->setText(problem);
    mExport->setEnabled(problem.isEmpty());
}

void ExportLayoutDialog::accept()
{
    if (mExport->isEnabled() && mPath->confirmReplacing())
        QDialog::accept();
}

} // namespace autocuts
