//! Algebras of the same name and the same text, in several modules.

macro_rules! declare {
    ($name:ident $(, $visibility:vis)?) => {
        ga_runtime::algebra! {
            /// A line.
            $($visibility)? mod $name {
                basis e1;
                signature 1;

                /// A vector.
                struct Vector { e1 }

                products { left_contraction(Vector, Vector); }
            }
        }
    };
}

mod first {
    declare!(line, pub(super));
}
mod second {
    declare!(line, pub);
}
mod third {
    declare!(line, pub);
}

mod tests {
    mod first {
        ga_runtime::testing::product_tests!(super::super::first::line);
    }
    mod second {
        ga_runtime::testing::product_tests!(super::super::second::line);
    }
    mod third {
        ga_runtime::testing::product_tests!(super::super::third::line);
    }
}
