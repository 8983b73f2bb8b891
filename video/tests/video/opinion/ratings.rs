//! Ratings against printed examples and plain sums.

use ga_files::table::Table;
use ga_video::opinion::OpinionError;
use ga_video::opinion::ratings::{Level, Rater, Ratings, Rows};

/// A table from one row of digits for each rater; a point stands for a missing rating.
fn table(rows: &[&str]) -> Ratings {
    let raters = rows.iter().enumerate().map(|(place, row)| Rater {
        name: place.to_string(),
        group: None,
        ratings: row
            .chars()
            .map(|digit| digit.to_digit(10).map(f64::from))
            .collect(),
    });
    let questions = (0..rows[0].len()).map(|question| format!("question {question}"));
    Ratings::new(questions.collect(), raters.collect()).unwrap()
}

/// The example of K. Krippendorff, "Computing Krippendorff's alpha-reliability", 2011: four
/// observers, twelve units.
#[test]
fn alpha_is_as_printed() {
    let ratings = table(&[
        "123321412...",
        "1233224125.3",
        ".3332342251.",
        "12332441251.",
    ]);
    let found = |level| ratings.alpha(level).unwrap();
    assert!(
        (found(Level::Interval) - 0.849).abs() < 5e-4,
        "{}",
        found(Level::Interval)
    );
    assert!(
        (found(Level::Ordinal) - 0.815).abs() < 5e-4,
        "{}",
        found(Level::Ordinal)
    );
}

#[test]
fn agreement_is_one_for_equal_raters_and_low_for_opposite_ones() {
    let equal = table(&["12345", "12345", "12345"]).agreement();
    assert_eq!(
        (equal.alpha_interval, equal.concordance),
        (Some(1.0), Some(1.0))
    );
    let opposite = table(&["12345", "54321"]).agreement();
    assert!(opposite.alpha_ordinal.unwrap() < 0.0);
    assert_eq!(opposite.concordance, Some(0.0));
    // Nothing varies.
    let constant = table(&["333", "333"]).agreement();
    assert_eq!(
        (constant.alpha_interval, constant.concordance),
        (None, None)
    );
}

/// Ranks of six things by three judges, without ties: the sums are 11, 9, 13, 6, 14 and 10, so that
/// `W = 12 Σ (R − 10.5)² / (m² (n³ − n)) = 12 · 41.5 / (9 · 210)`.
#[test]
fn concordance_is_that_of_the_sums_of_ranks() {
    let ratings = table(&["164253", "523164", "544...", "526163"]);
    // The third judge has missing ratings and does not count; the fourth has ties.
    assert!(ratings.agreement().concordance.is_some());
    let complete = table(&["164253", "421365", "635124"]);
    let sums = [11.0, 11.0, 10.0, 6.0, 13.0, 12.0_f64];
    let squares: f64 = sums.iter().map(|sum| (sum - 10.5).powi(2)).sum();
    let found = complete.agreement().concordance.unwrap();
    assert!(
        (found - 12.0 * squares / (9.0 * 210.0)).abs() < 1e-12,
        "{found}"
    );
}

#[test]
fn the_interval_of_the_mean_is_that_of_student() {
    // Mean 3, variance 2.5, and t = 2.776445 for four degrees of freedom.
    let ratings = table(&["1", "2", "3", "4", "5"]);
    let found = ratings.mean_opinion(0, None, 0.95).unwrap();
    assert_eq!((found.mean, found.ratings), (3.0, 5));
    assert!((found.deviation.unwrap() - 2.5_f64.sqrt()).abs() < 1e-15);
    assert!((found.half_width.unwrap() - 2.776_445_105 * 0.5_f64.sqrt()).abs() < 1e-7);
    let one = table(&["1.", "33"]).mean_opinion(1, None, 0.95).unwrap();
    assert_eq!((one.mean, one.deviation, one.half_width), (3.0, None, None));
    let error = ratings.mean_opinion(0, Some("expert"), 0.95);
    assert!(matches!(error, Err(OpinionError::TooFew { .. })));
    assert_eq!(
        ratings.mean_opinion(0, None, 0.0),
        Err(OpinionError::Confidence(0.0))
    );
}

/// Twenty raters of five questions; one answers without order, as far above as below the others.
#[test]
fn who_answers_without_order_is_rejected() {
    let mut rows = vec!["45454"; 10];
    rows.extend(["44444"; 5]);
    rows.extend(["55555"; 4]);
    let calm = table(&rows);
    assert!(calm.screening().iter().all(|rater| !rater.is_rejected));
    // Ten ratings around 5 for each question, each by two raters, and one rater 3 off both ways:
    // the standard deviation is 1.28, and the kurtosis 2.9.
    let pattern = ['3', '4', '4', '5', '5', '5', '5', '6', '6', '7'];
    let ordinary: Vec<String> = (0..20)
        .map(|rater| {
            (0..10)
                .map(|question| pattern[(rater + 3 * question) % 10])
                .collect()
        })
        .collect();
    let with = |last: &'static str| {
        let rows: Vec<&str> = ordinary.iter().map(String::as_str).chain([last]).collect();
        table(&rows)
    };
    let ratings = with("2828282828");
    let found = ratings.screening();
    let last = found.last().unwrap();
    assert_eq!((last.above, last.below, last.ratings), (5, 5, 10));
    let rejected: Vec<usize> = (0..found.len())
        .filter(|rater| found[*rater].is_rejected)
        .collect();
    assert_eq!(rejected, [20]);
    assert_eq!(ratings.without(&rejected).unwrap().raters().len(), 20);
    // Always too high is not without order.
    let last = with("8888888888").screening()[20];
    assert_eq!((last.above, last.below, last.is_rejected), (10, 0, false));
    assert_eq!(last.correlation, None);
}

#[test]
fn wrong_tables_are_named() {
    let rater = |name: &str, ratings: &[f64]| Rater {
        name: name.to_owned(),
        group: None,
        ratings: ratings.iter().copied().map(Some).collect(),
    };
    let questions = || vec!["clarity".to_owned(), "realism".to_owned()];
    let message = |raters| Ratings::new(questions(), raters).unwrap_err().to_string();
    let good = || rater("Ada", &[1.0, 2.0]);
    assert_eq!(
        message(vec![good()]),
        "1 raters are too few; at least 2 are needed"
    );
    assert_eq!(
        message(vec![good(), rater("Bob", &[1.0])]),
        "rater Bob has 1 ratings, but there are 2 questions"
    );
    assert_eq!(
        message(vec![good(), rater("Bob", &[1.0, f64::INFINITY])]),
        "rater Bob, question realism: inf is not a finite number"
    );
    assert_eq!(message(vec![good(), good()]), "the rater Ada occurs twice");
}

#[test]
fn the_first_name_says_what_rows_are() {
    let rows =
        |names: &str| Rows::of(&Table::with_names(format!("{names}\n1,2,3\n").as_bytes()).unwrap());
    for name in [
        "rater",
        "Observer",
        "subject_id",
        "participants",
        "group,Subject ID",
        "Viewer No.",
    ] {
        let more = if name.contains(',') { "b" } else { "a,b" };
        assert_eq!(rows(&format!("{name},{more}")), Ok(Rows::Raters), "{name}");
    }
    for name in [
        "clip",
        "Stimulus",
        "video name",
        "images",
        "PVS",
        "pvs_id",
        "src",
        "filename",
    ] {
        assert_eq!(rows(&format!("{name},a,b")), Ok(Rows::Stimuli), "{name}");
    }
    for name in ["", "who", "id", "score", "judgement", "srcode"] {
        let error = Err(OpinionError::Orientation { name: name.into() });
        assert_eq!(rows(&format!("{name},a,b")), error, "{name}");
    }
}

/// A table and the same with rows and columns exchanged have the same ratings.
#[test]
fn a_table_of_clips_is_one_of_raters_transposed() {
    let read =
        |text: &str, rows| Ratings::of_table(&Table::with_names(text.as_bytes()).unwrap(), rows);
    let raters = read("rater,clipA,clipB\ns1,1,3\ns2,2,\ns3,1,3\n", Rows::Raters);
    let clips = read(
        "clip;s1;s2;s3\nclipA;1,0;2;1\nclipB;3;NA;3\n",
        Rows::Stimuli,
    );
    assert_eq!(raters, clips);
    let groups = read("clip,group,s1,s2\na,x,1,2\n", Rows::Stimuli);
    assert_eq!(groups, Err(OpinionError::Groups));
    let Some(path) = nullcone_shared_data::shared("cases/video/ratings-transposed/t.csv") else {
        return;
    };
    let table = Table::with_names(&std::fs::read(path).unwrap()).unwrap();
    assert_eq!(Rows::of(&table), Ok(Rows::Stimuli));
    let ratings = Ratings::of_table(&table, Rows::Stimuli).unwrap();
    assert_eq!(ratings.questions(), ["clipA", "clipB", "clipC"]);
    assert_eq!(ratings.of_question(0, None), [1.0, 2.0, 1.0]);
    assert_eq!(ratings.of_question(2, None), [5.0, 5.0, 5.0]);
}
