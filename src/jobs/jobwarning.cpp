#include "jobs/jobwarning.h"

#include "jobs/jobtexts.h"

namespace autocuts::jobs {

namespace {

//! Share of the texels. Chosen by hand.
constexpr double leastShare = 0.001;

QString percent(double share)
{
    return QString::number(100 * share, 'f', 1);
}

} // namespace

void addSaid(Warnings &warnings, const QStringList &texts)
{
    for (const QString &text : texts)
        warnings.push_back({Warning::Kind::Said, 0, {text}});
}

void addTexels(Warnings &warnings, Warning::Kind kind, long long some, long long all)
{
    const double share = all > 0 ? double(some) / double(all) : 0;
    if (share >= leastShare)
        warnings.push_back({kind, share});
}

QString textOf(const Warning &warning)
{
    const QString names = warning.names.join(QStringLiteral(", "));
    switch (warning.kind) {
    case Warning::Kind::Said:
        return names;
    case Warning::Kind::FacesNotBaked:
        return JobTexts::tr(
            "%n faces are not baked as a whole: they have no UVs, or their islands reach over the "
            "border of their tile",
            nullptr, static_cast<int>(warning.number));
    case Warning::Kind::FacesWithoutPicture:
        return JobTexts::tr("%n faces get nothing: they have no UVs, or their islands cross the border "
                            "of a tile",
                            nullptr, static_cast<int>(warning.number));
    case Warning::Kind::NoSuchColors:
        return JobTexts::tr("The model has no colours of the chosen kind: those of its materials are "
                            "baked");
    case Warning::Kind::UnreadableTextures:
        return JobTexts::tr("Textures that cannot be read: %1").arg(names);
    case Warning::Kind::MissingPictures:
        return JobTexts::tr("Pictures that are not there: %1").arg(names);
    case Warning::Kind::UnpairedObjects:
        return JobTexts::tr("No object of the detailed model belongs to: %1").arg(names);
    case Warning::Kind::NoCage:
        return JobTexts::tr("The detailed model is nowhere near this one: the cage is %1 % of its "
                            "diagonal")
            .arg(100 * warning.number);
    case Warning::Kind::TexelsMissed:
        return JobTexts::tr(
                   "%1 % of the texels found nothing of the detailed model: a larger cage reaches farther")
            .arg(percent(warning.number));
    case Warning::Kind::CarriedTexelsMissed:
        return JobTexts::tr("%1 % of the texels found nothing of the other model")
            .arg(percent(warning.number));
    case Warning::Kind::TexelsShared:
        return JobTexts::tr("%1 % of the texels are shared by several faces and show the first one")
            .arg(percent(warning.number));
    case Warning::Kind::LightCutOff:
        return JobTexts::tr("In %1 % of the texels light is above 1 and was cut off: EXR keeps it, or "
                            "take weaker lights")
            .arg(100 * warning.number, 0, 'f', 0);
    }
    return {};
}

QStringList textsOf(const Warnings &warnings)
{
    QStringList texts;
    for (const Warning &warning : warnings)
        texts << textOf(warning);
    return texts;
}

} // namespace autocuts::jobs
