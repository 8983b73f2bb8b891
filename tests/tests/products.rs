//! Every declared product of every algebra of ga-runtime, exactly equal to the dense reference.

mod cga2 {
    ga_runtime::testing::product_tests!(ga_runtime::cga2);
}

mod cga3 {
    ga_runtime::testing::product_tests!(ga_runtime::cga3);
}

mod pga2 {
    ga_runtime::testing::product_tests!(ga_runtime::pga2);
}

mod pga3 {
    ga_runtime::testing::product_tests!(ga_runtime::pga3);
}

mod sta {
    ga_runtime::testing::product_tests!(ga_runtime::sta);
}

mod vga2 {
    ga_runtime::testing::product_tests!(ga_runtime::vga2);
}

mod vga3 {
    ga_runtime::testing::product_tests!(ga_runtime::vga3);
}
