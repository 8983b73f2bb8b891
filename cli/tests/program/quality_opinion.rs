//! `nullcone quality fit` and `nullcone quality ratings`: people's judgement.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

fn run(folder: &Path, arguments: &[&str]) -> std::process::Output {
    nullcone(folder, ["quality"].iter().chain(arguments))
}

fn json(output: &std::process::Output) -> Value {
    assert_success(output);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The table of the shared scores with one measure, and what SciPy found for it.
fn table() -> Option<(String, Value)> {
    let path = nullcone_shared_data::shared("oracle/vision/seed1/truth.json")?;
    let truth: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let [first, .., last] = truth["logistic_vqeghd3"].as_array().unwrap().as_slice() else {
        panic!("there are several measures");
    };
    let mut csv = "clip,Objective,subjective,worse\n".to_owned();
    let rows = last["mos"].as_array().unwrap().iter().enumerate();
    for (row, mos) in rows {
        writeln!(csv, "{row},{},{mos},{}", last["x"][row], first["x"][row]).unwrap();
    }
    Some((csv, last.clone()))
}

#[test]
fn a_measure_is_fitted_as_scipy_fits_it() {
    let Some((csv, truth)) = table() else { return };
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("scores.csv"), csv).unwrap();
    let arguments = [
        "fit",
        "scores.csv",
        "--json",
        "--draws",
        "200",
        "--plot",
        "fit.svg",
        "--report",
        "fit.html",
    ];
    let found = json(&run(
        folder.path(),
        &[&arguments[..], &["--against", "worse"]].concat(),
    ));
    let number = |value: &Value| value.as_f64().unwrap();
    for curve in ["logistic4", "logistic5"] {
        let (found, truth) = (&found[curve], &truth[curve]);
        assert!(number(&found["sse"]) <= (1.0 + 1e-6) * number(&truth["sse"]));
        assert!(number(&found["plcc"]) > number(&truth["plcc"]) - 1e-6);
        let parameters = found["parameters"].as_array().unwrap().len();
        assert_eq!(parameters, truth["params"].as_array().unwrap().len());
    }
    for rank in ["srocc", "krocc"] {
        assert!((number(&found[rank]) - number(&truth[rank])).abs() < 1e-12);
    }
    assert_eq!(found["plcc"], found["logistic5"]["plcc"]);
    assert_eq!(found["logistic5"]["held_monotone"], false);
    for key in ["unfitted_plcc", "plcc", "srocc", "krocc", "outlier_ratio"] {
        let ends = found[&format!("{key}_interval")].as_array().unwrap();
        assert!(number(&ends[0]) <= number(&found[key]), "{key}");
        assert!(number(&found[key]) <= number(&ends[1]), "{key}");
    }
    assert!(number(&found["rmse"]) > 0.0);
    assert!(number(&found["against"]["plcc_difference"]) > 0.1);
    assert!(number(&found["against"]["correlation_p_value"]) < 1e-3);
    let of_errors = &found["against"]["error_p_value"];
    assert!(number(of_errors) < 1e-3 && *of_errors != found["against"]["correlation_p_value"]);
    let svg = std::fs::read_to_string(folder.path().join("fit.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.matches("<circle").count() >= 63);
    let page = std::fs::read_to_string(folder.path().join("fit.html")).unwrap();
    assert!(page.contains(svg.trim_end()) && page.ends_with("</html>\n"));
    let [low, high] = [0, 1].map(|k| number(&found["srocc_interval"][k]));
    let row = format!(
        "<td>SROCC</td><td>{:.4}</td><td>{low:.4} to {high:.4}</td>",
        number(&found["srocc"])
    );
    assert!(page.contains(&row), "{page}");
    assert!(page.contains("Against the measure worse"));
    // Text for people, and the same numbers for the same seed.
    let output = run(folder.path(), &["fit", "scores.csv"]);
    let lines = text(&output.stdout);
    let places = [
        "63 scores",
        "unfitted PLCC",
        "SROCC",
        "KROCC",
        "logistic curve",
        "RMSE",
    ];
    let places = places.map(|part| lines.find(part).unwrap());
    assert!(places.is_sorted(), "{lines}");
    let again = json(&run(
        folder.path(),
        &[&arguments[..], &["--against", "worse"]].concat(),
    ));
    assert_eq!(found, again);
}

#[test]
fn wrong_scores_are_named_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    for (csv, message) in [
        (
            "objective,subjective\n1,2\n2,nan\n",
            "line 3, column subjective: \"nan\" is not a finite number",
        ),
        (
            "objective,mos\n1,2\n",
            "there is no column subjective; the first line names objective, mos",
        ),
        (
            "objective,subjective\n1,2\n2,3\n3,5\n4,4\n",
            "4 scores are too few; at least 5 are needed",
        ),
        (
            "objective,subjective\n1,2\n1,3\n1,4\n1,5\n1,1\n",
            "all numbers of the column objective are equal",
        ),
        (
            "objective,subjective\n1,2\n2\n",
            "line 3 has 1 cells, and the first line names 2 columns",
        ),
    ] {
        std::fs::write(folder.path().join("scores.csv"), csv).unwrap();
        let output = run(
            folder.path(),
            &[
                "fit",
                "scores.csv",
                "--plot",
                "fit.svg",
                "--report",
                "f.html",
            ],
        );
        assert_failure(&output, &[message]);
        assert_eq!(names(folder.path()), ["scores.csv"]);
    }
}

/// A device that is always full fails when all outputs are complete.
#[cfg(target_os = "linux")]
#[test]
fn a_report_that_cannot_be_written_leaves_no_other_output() {
    let folder = tempdir().unwrap();
    let scores = "objective,subjective\n1,1\n2,2\n3,2.5\n4,4\n5,4.2\n6,5\n";
    std::fs::write(folder.path().join("scores.csv"), scores).unwrap();
    let outputs = ["--plot", "fit.svg", "--report", "/dev/full"];
    let output = run(
        folder.path(),
        &[&["fit", "scores.csv", "--draws", "10"], &outputs[..]].concat(),
    );
    assert_failure(&output, &["cannot write /dev/full"]);
    assert_eq!(names(folder.path()), ["scores.csv"]);
}

const RATINGS: &str = "rater,group,A,B\n\
    1,expert,4,5\n2,expert,5,5\n3,lay,3,4\n4,lay,2,\n5,lay,4,4\n";

#[test]
fn ratings_are_evaluated_by_question_and_group() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("table.csv"), RATINGS).unwrap();
    let arguments = [
        "ratings",
        "table.csv",
        "--json",
        "--plot",
        "ratings.svg",
        "--report",
        "ratings.html",
    ];
    let found = json(&run(folder.path(), &arguments));
    assert_eq!(found["raters"], 5);
    let first = &found["questions"][0];
    assert_eq!(first["question"], "A");
    assert_eq!(first["mean_opinion_score"], 3.6);
    assert_eq!(first["groups"]["expert"]["mean_opinion_score"], 4.5);
    assert_eq!(first["groups"]["lay"]["ratings"], 3);
    assert_eq!(first["counts"]["4"], 2);
    let difference = &first["differences"][0];
    assert_eq!(
        (&difference["first"], &difference["difference"]),
        (&"expert".into(), &1.5.into())
    );
    // A missing rating does not count.
    assert_eq!(found["questions"][1]["ratings"], 4);
    assert_eq!(
        found["questions"][1]["groups"]["lay"]["interval"],
        serde_json::json!([4.0, 4.0])
    );
    assert_eq!(found["rejected"], serde_json::json!([]));
    let svg = std::fs::read_to_string(folder.path().join("ratings.svg")).unwrap();
    assert!(svg.contains("Raters by rating") && svg.contains("expert"));
    let page = std::fs::read_to_string(folder.path().join("ratings.html")).unwrap();
    assert!(page.contains(svg.trim_end()) && page.ends_with("</html>\n"));
    assert!(
        page.contains("<td></td><td>expert</td><td>4.500</td>"),
        "{page}"
    );
    assert!(page.contains("<td>A</td><td>expert − lay</td><td>+1.500</td>"));
    let output = run(folder.path(), &["ratings", "table.csv", "--screen"]);
    let lines = text(&output.stdout);
    assert!(lines.contains("A: 3.60 (2.18 to 5.02)"), "{lines}");
}

/// One of 13 raters answers high and low in turn, beyond two standard deviations of the others.
#[test]
fn screening_leaves_out_who_answers_without_order() {
    let folder = tempdir().unwrap();
    let mut csv = "rater,A,B,C,D\n".to_owned();
    for (place, rating) in [2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4].iter().enumerate() {
        writeln!(csv, "r{place},{rating},{rating},{rating},{rating}").unwrap();
    }
    csv += "random,5,1,5,1\n";
    std::fs::write(folder.path().join("table.csv"), csv).unwrap();
    for (screen, raters, mean) in [(false, 13, 41.0 / 13.0), (true, 12, 3.0)] {
        let arguments = ["ratings", "table.csv", "--json", "--screen"];
        let found = json(&run(folder.path(), &arguments[..3 + usize::from(screen)]));
        assert_eq!(found["rejected"], serde_json::json!(["random"]));
        assert_eq!(
            (&found["raters"], &found["screened"]),
            (&raters.into(), &screen.into())
        );
        let got = found["questions"][0]["mean_opinion_score"]
            .as_f64()
            .unwrap();
        assert!((got - mean).abs() < 1e-12, "{got}");
        // All raters are listed, also those who are left out.
        assert_eq!(found["screening"].as_array().unwrap().len(), 13);
    }
}

#[test]
fn raters_may_have_no_names() {
    let folder = tempdir().unwrap();
    let rows_are_raters = ["ratings", "table.csv", "--json", "--rows", "raters"];
    std::fs::write(folder.path().join("table.csv"), "A,B\n4,5\n5,3\n").unwrap();
    let found = json(&run(folder.path(), &rows_are_raters));
    assert_eq!(found["screening"][1]["rater"], "2");
    assert_eq!(found["questions"].as_array().unwrap().len(), 2);
    std::fs::write(folder.path().join("table.csv"), "who,A\nAda,5\nBob,3\n").unwrap();
    let found = json(&run(folder.path(), &rows_are_raters));
    assert_eq!(found["screening"][1]["rater"], "Bob");
    // Nothing says what the rows are.
    let output = run(folder.path(), &["ratings", "table.csv"]);
    assert_failure(
        &output,
        &["table.csv", "\"who\"", "--rows raters or --rows stimuli"],
    );
}

#[test]
fn rows_of_clips_are_read_as_clips() {
    let folder = tempdir().unwrap();
    let table = "clip,s1,s2,s3\nclipA,1,2,1\nclipB,3,4,3\nclipC,5,5,5\n";
    std::fs::write(folder.path().join("t.csv"), table).unwrap();
    let found = json(&run(folder.path(), &["ratings", "t.csv", "--json"]));
    assert_eq!(
        (&found["rows"], &found["raters"]),
        (&"stimuli".into(), &3.into())
    );
    let questions = found["questions"].as_array().unwrap();
    for (question, (name, mean)) in
        questions
            .iter()
            .zip([("clipA", 4.0 / 3.0), ("clipB", 10.0 / 3.0), ("clipC", 5.0)])
    {
        assert_eq!(question["question"], name);
        let found = question["mean_opinion_score"].as_f64().unwrap();
        assert!((found - mean).abs() < 1e-12, "{name}: {found}");
    }
    let output = run(folder.path(), &["ratings", "t.csv"]);
    assert!(text(&output.stdout).starts_with("3 raters; the rows are stimuli\n"));
}

/// A sine of opinions, and too few scores, in the dialect of a spreadsheet.
#[test]
fn fits_that_say_little_are_named() {
    let folder = tempdir().unwrap();
    let rows = (0..60).map(|k| {
        let x = f64::from(k) / 2.0;
        format!("{x};{}\n", 3.0 + 1.5 * (0.18 * x - 1.9).sin())
    });
    let csv = format!("objective;subjective\n{}", rows.collect::<String>()).replace('.', ",");
    std::fs::write(folder.path().join("sine.csv"), csv).unwrap();
    let found = json(&run(
        folder.path(),
        &["fit", "sine.csv", "--json", "--draws", "20"],
    ));
    assert_eq!(found["logistic5"]["held_monotone"], true);
    assert_eq!(found["warnings"][0]["kind"], "held_monotone");
    let [fitted, unfitted] = ["plcc", "unfitted_plcc"].map(|key| found[key].as_f64().unwrap());
    assert!(unfitted < fitted && fitted < 0.95, "{unfitted} {fitted}");
    let few = "objective;subjective\n30,1;2,1\n31,5;2,9\n33,0;3,5\n35,2;4,1\n38,0;4,6\n";
    std::fs::write(folder.path().join("few.csv"), few).unwrap();
    let output = run(
        folder.path(),
        &["fit", "few.csv", "--draws", "20", "--json"],
    );
    assert_eq!(json(&output)["warnings"][0]["kind"], "few_scores");
    assert!(text(&output.stderr).contains("5 scores are few for a curve with 5 parameters"));
}

#[test]
fn wrong_ratings_are_named_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    for (csv, message) in [
        (
            "rater,A\n1,4\n",
            "1 raters are too few; at least 2 are needed",
        ),
        (
            "rater,A\n1,4\n2,good\n",
            "line 3, column A: \"good\" is not a finite number",
        ),
        ("rater,A\n1,4\n1,5\n", "the rater 1 occurs twice"),
        ("rater,A,B\n1,4,\n2,5,\n", "the question B has no ratings"),
        ("rater,group\n1,lay\n2,lay\n", "0 questions are too few"),
    ] {
        std::fs::write(folder.path().join("table.csv"), csv).unwrap();
        let output = run(
            folder.path(),
            &[
                "ratings",
                "table.csv",
                "--plot",
                "r.svg",
                "--report",
                "r.html",
            ],
        );
        assert_failure(&output, &[message]);
        assert_eq!(names(folder.path()), ["table.csv"]);
    }
}
