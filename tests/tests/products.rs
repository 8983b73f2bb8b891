//! Every declared product of every algebra of ga-runtime, exactly equal to the dense reference.

macro_rules! products_of {
    ($($algebra:ident),*) => { $(
        mod $algebra {
            ga_runtime::testing::product_tests!(ga_runtime::$algebra);
        }
    )* };
}

ga_runtime::__algebras!(products_of);

/// A macro that emitted nothing would leave the products without tests, and this binary green.
#[test]
fn each_algebra_has_its_tests() {
    let program = std::env::current_exe().unwrap();
    let output = std::process::Command::new(program).arg("--list").output();
    let list = String::from_utf8(output.unwrap().stdout).unwrap();
    for name in [
        "cga2::commutator_point_pair_and_point_pair",
        "cga3::geometric_motor_and_motor",
    ] {
        let line = format!("{name}: test");
        assert!(list.lines().any(|other| other == line), "{name}");
    }
}
