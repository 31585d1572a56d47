use imogene_verif::formal::catalogue;
use imogene_verif::formal::mutants::MUTANTS;

#[test]
fn every_mutant_edits_the_design_of_its_job() {
    let jobs = catalogue::jobs();
    for mutant in MUTANTS {
        let job = jobs.iter().find(|job| job.name == mutant.job);
        let job = job.unwrap_or_else(|| panic!("no job {}", mutant.job));
        let (good, bad) = (job.source(None).unwrap(), job.source(Some(mutant)).unwrap());
        assert_ne!(good, bad, "{}", mutant.name);
    }
}

#[test]
fn a_text_that_is_not_there_once_is_refused() {
    // A pixel adds b instead of a.
    let mutant = MUTANTS[0];
    let (good, bad) = ("pixel_value + a", "pixel_value + b");
    assert!(mutant.apply(bad).is_err() && mutant.apply(&format!("{good}; {good}")).is_err());
    let edited = mutant.apply(&format!("x = {good};"));
    assert_eq!(edited.unwrap(), format!("x = {bad};"));
}

#[test]
fn every_property_has_a_mutant() {
    // Families: the name of a job before its width.
    let family = |name: &str| {
        name.rsplit_once('-')
            .map_or(name.to_owned(), |(head, _)| head.to_owned())
    };
    let whole = |name: &str| name.split('-').next().unwrap_or(name).to_owned();
    for job in catalogue::jobs() {
        let found = MUTANTS.iter().any(|m| {
            if job.name.ends_with("-integers") {
                m.job == job.name
            } else {
                family(m.job) == family(&job.name) || whole(m.job) == whole(&job.name)
            }
        });
        assert!(found, "{} has no mutant", job.name);
    }
}
