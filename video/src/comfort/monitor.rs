//! All rows for all frames of a video.

use std::collections::VecDeque;

use ga_image::plane::PlaneError;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::asynchrony::{Asynchrony, AsynchronyMeter};
use super::change::{Changes, PairDetector};
use super::depth::Depth;
use super::deviation::DeviationMeter;
use super::observer::{Each, Observer};
use super::order::{Order, Place};
use super::record::Known;
use super::stereoscopy::{Alignment, Stereoscopy, StereoscopyMeter};
use super::{FrameMeasures, FrameMeter, Record, Viewing};
use crate::comfort::ComfortError;
use crate::stereo::{Layout, StereoSource};
use crate::{Frame, Properties, Samples};

/// How a video is analysed.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The eyes before the screen.
    pub viewing: Viewing,
    /// How the views lie in a frame; `None` for two videos. Views in one frame that are parts of
    /// one picture are an error.
    pub layout: Option<Layout>,
    /// The number of threads: 1, or 2 for any other number. Results do not depend on it.
    pub threads: usize,
}

/// Frames that are measured at the same time.
const BATCH: usize = 4;

/// A pair of views in which the border of one continues in the other: their difference there is at
/// most this multiple of that of neighbouring lines.
const CONTINUES: f64 = 2.0;

/// Analyses the whole of a video, and hands over the record of each frame in order.
///
/// Records come 28 frames late, since the delay between the eyes needs later frames; memory does
/// not depend on the length of the video.
///
/// # Errors
///
/// [`ComfortError`]. All frames before an error have been handed over.
pub fn analyse(
    source: &mut StereoSource,
    options: Options,
    each: impl FnMut(Record),
) -> Result<(), ComfortError> {
    observe(source, options, &mut Each(each))
}

/// Analyses the whole of a video as [`analyse`] does, and tells an observer.
///
/// # Errors
///
/// [`ComfortError`]. The records of all frames before an error have been handed over.
pub fn observe(
    source: &mut StereoSource,
    options: Options,
    observer: &mut impl Observer,
) -> Result<(), ComfortError> {
    observe_measured(source, options, [], observer)
}

/// Analyses the whole of a video as [`observe`] does, whose first frames were measured before, by
/// [`measure`](super::measure): these measures are taken as they are.
///
/// # Errors
///
/// [`ComfortError`]. The records of all frames before an error have been handed over.
pub fn observe_measured(
    source: &mut StereoSource,
    options: Options,
    measures: impl Into<VecDeque<FrameMeasures>>,
    observer: &mut impl Observer,
) -> Result<(), ComfortError> {
    let mut monitor = Monitor::new(source.properties(), options)?;
    monitor.measured = measures.into();
    let mut batch: Vec<[Frame; 2]> = vec![Default::default(); BATCH];
    loop {
        let mut count = 0;
        let mut failure = None;
        while count < BATCH {
            match source.read(&mut batch[count]) {
                Ok(true) => count += 1,
                Ok(false) => break,
                Err(error) => {
                    failure = Some(error);
                    break;
                }
            }
        }
        let pushed = monitor.push_observed(&batch[..count], observer);
        if count < BATCH || pushed.is_err() {
            monitor.finish_observed(observer);
        }
        pushed?;
        if let Some(failure) = failure {
            return Err(failure.into());
        }
        if count < BATCH {
            return Ok(());
        }
    }
}

/// Analyses frames as they come.
#[derive(Debug)]
pub struct Monitor {
    options: Options,
    properties: Properties,
    threads: ThreadPool,
    meters: Vec<FrameMeter>,
    /// The measures of the next frames, where they are known.
    measured: VecDeque<FrameMeasures>,
    asynchrony: AsynchronyMeter,
    changes: PairDetector,
    deviation: DeviationMeter,
    order: Order,
    /// The last run of frames whose records were handed over, and the order of the eyes that they
    /// have in common.
    before: (usize, Option<Stereoscopy>),
    pending: VecDeque<Pending>,
}

/// A frame whose delay is not yet known.
#[derive(Debug)]
struct Pending {
    frame: usize,
    time_seconds: f64,
    begins_shot: bool,
    measures: FrameMeasures,
    deviation_arcminutes: Option<f64>,
    /// Where it is among the parts with one order of the eyes.
    place: Place,
}

impl Monitor {
    /// A monitor for views with these properties.
    ///
    /// # Errors
    ///
    /// [`ComfortError::Threads`].
    pub fn new(properties: &Properties, options: Options) -> Result<Self, ComfortError> {
        let threads = if options.threads == 1 { 1 } else { 2 };
        let meter = FrameMeter::new(properties.size, properties.colours)
            .with_pixel_aspect(properties.pixel_aspect);
        Ok(Self {
            options,
            properties: *properties,
            threads: ThreadPoolBuilder::new().num_threads(threads).build()?,
            meters: vec![meter; BATCH],
            measured: VecDeque::new(),
            asynchrony: AsynchronyMeter::default(),
            changes: Default::default(),
            deviation: DeviationMeter::default(),
            order: Order::default(),
            before: Default::default(),
            pending: VecDeque::new(),
        })
    }

    /// Takes the next frames, and hands over the records of those that are complete.
    ///
    /// # Errors
    ///
    /// [`ComfortError`]; frames before the one that it names are taken.
    pub fn push(
        &mut self,
        frames: &[[Frame; 2]],
        each: &mut impl FnMut(Record),
    ) -> Result<(), ComfortError> {
        self.push_observed(frames, &mut Each(each))
    }

    fn push_observed(
        &mut self,
        frames: &[[Frame; 2]],
        observer: &mut impl Observer,
    ) -> Result<(), ComfortError> {
        let size = self.properties.size;
        let fits = |views: &&[Frame; 2]| views.iter().all(|view| view.samples.size() == size);
        let count = frames.iter().take_while(fits).count();
        for batch in frames[..count].chunks(BATCH) {
            self.push_batch(batch, observer)?;
        }
        let other = frames.get(count).and_then(|views| {
            let mut sizes = views.iter().map(|view| (view.index, view.samples.size()));
            sizes.find(|(_, found)| *found != size)
        });
        match other {
            Some((frame, found)) => Err(ComfortError::Size {
                frame,
                source: PlaneError::Differs {
                    first: found,
                    second: size,
                },
            }),
            None => Ok(()),
        }
    }

    fn push_batch(
        &mut self,
        batch: &[[Frame; 2]],
        observer: &mut impl Observer,
    ) -> Result<(), ComfortError> {
        let Self {
            threads,
            meters,
            measured,
            asynchrony,
            changes,
            properties,
            ..
        } = self;
        let mut measures: Vec<_> = batch.iter().map(|_| Ok(FrameMeasures::default())).collect();
        let (mut delays, mut seen) = (Vec::new(), Vec::new());
        threads.scope(|scope| {
            for ((views, meter), target) in batch.iter().zip(meters).zip(&mut measures) {
                if let Some(known) = measured.pop_front() {
                    *target = Ok(known);
                    continue;
                }
                scope.spawn(move |_| {
                    let found = meter.measure(&views[0].samples, &views[1].samples);
                    *target = found.cloned();
                });
            }
            scope.spawn(|_| {
                for views in batch {
                    let [left, right] = views.each_ref().map(|view| &view.samples);
                    delays.push(asynchrony.push(left, right));
                    seen.push(changes.push([left, right], properties.colours));
                }
            });
        });
        let together = batch.iter().zip(measures).zip(delays.into_iter().zip(seen));
        for ((views, measures), (delay, changes)) in together {
            let frame = views[0].index;
            let measures = measures.map_err(|source| ComfortError::Size { frame, source })?;
            observer.measured(views, &measures);
            self.take(views, measures, changes)?;
            if let Some(delay) = delay {
                self.emit(delay, observer);
            }
        }
        Ok(())
    }

    /// Takes one frame that has been measured.
    fn take(
        &mut self,
        views: &[Frame; 2],
        measures: FrameMeasures,
        changes: Changes,
    ) -> Result<(), ComfortError> {
        let frame = views[0].index;
        let is_cut = changes.views[0].is_cut && !changes.is_exchange;
        let begins_shot = self.order.frames() == 0 || is_cut;
        let parallax = measures.parallax.as_ref();
        let median = parallax.map(|parallax| parallax.percent(parallax.median_px));
        let deviation_arcminutes = self
            .deviation
            .push(median, begins_shot, &self.options.viewing);
        let [left, right] = views.each_ref().map(|view| &view.samples);
        let depth = Depth::of(&measures, self.properties.size);
        let place = self.order.begin_frame(changes, depth);
        if place.is_due {
            let alignment = measures
                .geometry
                .as_ref()
                .map(|geometry| Alignment::from(geometry).in_pixels(geometry.pixel_height));
            let alignment = alignment.unwrap_or_default();
            let meter = self.order.meter();
            let added = self.threads.install(|| meter.add(left, right, &alignment));
            added.map_err(|source| ComfortError::Match { frame, source })?;
            let verdict = self.order.meter().verdict();
            if verdict == Stereoscopy::Unrelated && self.is_one_picture(left, right) {
                // Nor do the frames before it show two views of different scenes.
                *self.order.meter() = StereoscopyMeter::default();
                return Err(ComfortError::Mono { frame });
            }
        }
        if place.is_exchange || self.order.begins_opposite() {
            self.asynchrony.exchange(self.order.frames() - 1);
        }
        self.pending.push_back(Pending {
            frame,
            time_seconds: views[0].time_seconds,
            begins_shot,
            measures,
            deviation_arcminutes,
            place,
        });
        Ok(())
    }

    /// Hands over the records of the frames that are left.
    pub fn finish(&mut self, each: &mut impl FnMut(Record)) {
        self.finish_observed(&mut Each(each));
    }

    fn finish_observed(&mut self, observer: &mut impl Observer) {
        for delay in self.asynchrony.finish() {
            self.emit(delay, observer);
        }
    }

    fn emit(&mut self, asynchrony: Asynchrony, observer: &mut impl Observer) {
        let Some(pending) = self.pending.pop_front() else {
            return;
        };
        let (mut stereoscopy, evidence) = self.order.verdict(&pending.place);
        let run = pending.place.run;
        let before = self.before.1.filter(|_| self.before.0 == run).into_iter();
        if stereoscopy == Stereoscopy::Unknown {
            let same = self
                .pending
                .iter()
                .take_while(|frame| frame.place.run == run);
            let later = same.filter_map(|frame| self.order.verdict(&frame.place).0.order());
            let common = Stereoscopy::common(before.chain(later));
            stereoscopy = common.unwrap_or(Stereoscopy::Unknown);
        } else {
            let common = Stereoscopy::common(before.chain(stereoscopy.order()));
            self.before = (run, common);
        }
        let known = Known {
            frame: pending.frame,
            time_seconds: pending.time_seconds,
            begins_shot: pending.begins_shot,
            run,
            measures: pending.measures,
            deviation_arcminutes: pending.deviation_arcminutes,
            asynchrony,
            stereoscopy,
            evidence,
        };
        observer.complete(Record::new(known, &self.options.viewing));
    }

    /// Whether the picture continues from one view to the other.
    fn is_one_picture(&self, left: &Samples, right: &Samples) -> bool {
        let Some(layout) = self.options.layout else {
            return false;
        };
        let [left, right] = [left.eight_bits(), right.eight_bits()];
        let [width, height] = self.properties.size;
        let axis = layout.axis();
        let (last, length) = ([width, height][axis] - 1, [width, height][1 - axis]);
        let line = |luma: &ga_image::plane::Plane<u8>, place: usize, along: usize| {
            let [column, row] = [[place, along], [along, place]][axis];
            f64::from(luma.get(column, row).unwrap_or(0))
        };
        if last == 0 {
            return false;
        }
        let (mut across, mut inside) = (0.0, 0.0);
        for along in 0..length {
            let [a, b] = [last - 1, last].map(|place| line(&left.luma, place, along));
            let [c, d] = [0, 1].map(|place| line(&right.luma, place, along));
            across += (b - c).abs();
            inside += 0.5 * ((a - b).abs() + (c - d).abs());
        }
        across <= CONTINUES * inside + 0.5 * length as f64
    }
}
