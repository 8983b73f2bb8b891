//! The board that a calibration looks for.

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_vision::board::{Board, Pattern};
use ga_vision::chessboard::BoardSize;
use ga_vision::tag::{AprilGrid, CharucoBoard, CharucoPattern, Dictionary};

/// What is printed on a board, and how large it is.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct BoardArguments {
    /// What is printed on the board.
    #[arg(long, value_enum, default_value_t = PatternChoice::Chessboard)]
    pattern: PatternChoice,
    /// Columns x rows: of inner corners or circles; of squares of a ChArUco board, as OpenCV counts
    /// them; of AprilTags.
    #[arg(long, value_name = "9x6")]
    board: BoardSize,
    /// The side of a square in metres; of circles, the distance of neighbouring rows; of AprilTags,
    /// that of the left edges of neighbours: kalibr's tagSize (1 + tagSpacing).
    #[arg(long, value_name = "METRES")]
    square: f64,
    /// The side of a tag, with its black border; for charuco and april-grid.
    #[arg(long, value_name = "METRES")]
    marker: Option<f64>,
    /// The tags of a ChArUco board, by OpenCV's name: 4X4_50, 5X5_100, 6X6_250, APRILTAG_36h11.
    #[arg(long, value_name = "NAME")]
    dictionary: Option<Dictionary>,
    /// A ChArUco board as OpenCV drew it before 4.6: with an even number of rows, the square at the
    /// top left has a tag.
    #[arg(long)]
    legacy_pattern: bool,
    /// How many modules wide the black border of AprilTags is: 2 as kalibr prints them, or 1.
    #[arg(long, value_name = "MODULES")]
    border: Option<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PatternChoice {
    /// A chessboard.
    Chessboard,
    /// Circles in columns and rows, all darker or all brighter than what is around them.
    Circles,
    /// Circles of which every other row is moved by half their distance in it.
    AsymmetricCircles,
    /// A chessboard with ArUco tags or AprilTags in its white squares.
    Charuco,
    /// kalibr's aprilgrid: AprilTags 36h11, numbered from 0 at the bottom left.
    #[value(alias = "aprilgrid")]
    AprilGrid,
}

impl BoardArguments {
    pub(crate) fn board(&self) -> Result<Board> {
        let is_charuco = self.pattern == PatternChoice::Charuco;
        let is_grid = self.pattern == PatternChoice::AprilGrid;
        for (is_given, is_used, text) in [
            (self.marker.is_some(), is_charuco || is_grid, "--marker"),
            (self.dictionary.is_some(), is_charuco, "--dictionary"),
            (self.legacy_pattern, is_charuco, "--legacy-pattern"),
            (self.border.is_some(), is_grid, "--border"),
        ] {
            ensure!(
                is_used || !is_given,
                "{text} is not about boards of --pattern {}",
                self.pattern_name()
            );
        }
        let plain = |pattern| {
            let board = Board::new(pattern, self.board, self.square);
            board.with_context(|| format!("--square {}", self.square))
        };
        match self.pattern {
            PatternChoice::Chessboard => plain(Pattern::Chessboard),
            PatternChoice::Circles => plain(Pattern::Circles),
            PatternChoice::AsymmetricCircles => plain(Pattern::AsymmetricCircles),
            PatternChoice::Charuco => self.charuco(),
            PatternChoice::AprilGrid => self.april_grid(),
        }
    }

    fn charuco(&self) -> Result<Board> {
        let dictionary = self.dictionary.context(
            "--pattern charuco needs --dictionary, the name of the tags, such as 5X5_100",
        )?;
        let pattern = match self.legacy_pattern {
            true => CharucoPattern::Legacy,
            false => CharucoPattern::Current,
        };
        let sides = [self.square, self.marker()?];
        let board = CharucoBoard::new(self.counts(), sides, dictionary, pattern);
        Ok(board.context("--pattern charuco")?.into())
    }

    fn april_grid(&self) -> Result<Board> {
        let side = self.marker()?;
        let border = self.border.unwrap_or(AprilGrid::BORDER_OF_KALIBR);
        let spacing = self.square / side - 1.0;
        let grid = AprilGrid::new(self.counts(), [side, spacing], border);
        Ok(grid.context("--pattern april-grid")?.into())
    }

    fn marker(&self) -> Result<f64> {
        self.marker.with_context(|| {
            format!(
                "--pattern {} needs --marker, the side of a tag in metres",
                self.pattern_name()
            )
        })
    }

    fn counts(&self) -> [usize; 2] {
        [self.board.columns(), self.board.rows()]
    }

    fn pattern_name(&self) -> String {
        let value = self.pattern.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }
}
