//! The board that a calibration looks for.

use anyhow::Result;
use clap::ValueEnum;
use ga_vision::board::{Board, Pattern};
use ga_vision::chessboard::BoardSize;

/// What is printed on a board, and how large it is.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct BoardArguments {
    /// What is printed on the board.
    #[arg(long, value_enum, default_value_t = PatternChoice::Chessboard)]
    pattern: PatternChoice,
    /// The number of inner corners, or of circles: columns x rows.
    #[arg(long, value_name = "9x6")]
    board: BoardSize,
    /// The side of a square in metres; of circles, the distance of neighbouring rows.
    #[arg(long, value_name = "METRES")]
    square: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PatternChoice {
    /// A chessboard.
    Chessboard,
    /// Dark circles in columns and rows.
    Circles,
    /// Dark circles of which every other row is moved by half their distance in it.
    AsymmetricCircles,
}

impl BoardArguments {
    pub(crate) fn board(&self) -> Result<Board> {
        let pattern = match self.pattern {
            PatternChoice::Chessboard => Pattern::Chessboard,
            PatternChoice::Circles => Pattern::Circles,
            PatternChoice::AsymmetricCircles => Pattern::AsymmetricCircles,
        };
        let board = Board::new(pattern, self.board, self.square);
        board.map_err(|error| anyhow::anyhow!("--square {}: {error}", self.square))
    }
}
