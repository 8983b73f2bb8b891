//! Every declared product of every algebra that ships, exactly equal to the dense reference.

mod cga3 {
    ga_runtime::testing::product_tests!(ga_runtime::cga3);
}

mod pga3 {
    ga_runtime::testing::product_tests!(ga_runtime::pga3);
}
