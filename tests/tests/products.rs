//! Every declared product of every algebra of ga-runtime, exactly equal to the dense reference.

macro_rules! products_of {
    ($($algebra:ident),*) => { $(
        mod $algebra {
            ga_runtime::testing::product_tests!(ga_runtime::$algebra);
        }
    )* };
}

ga_runtime::__algebras!(products_of);
