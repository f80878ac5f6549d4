// Speed and wrong pixels of one method on a scene, in the worker.
'use strict';

/** A browser's clock may go in tenths of a millisecond: what is timed goes on longer than that. */
const kLeastTimed = 5;

/** And first it compiles anew what is called often. */
const kWarming = 80;

/** How long a call takes, in milliseconds: the mean of as many calls as the clock needs to tell. */
function mean_time(call, least) {
  const begin = performance.now();
  for (let made = 1;; ++made) {
    call();
    const passed = performance.now() - begin;
    if (passed >= least) return passed / made;
  }
}

/** The median of such times, of fewer if they are long. */
function median_time(call) {
  const kSamples = 9, kLongest = 1500;
  const begin = performance.now();
  mean_time(call, kWarming);
  const times = [];
  do times.push(mean_time(call, kLeastTimed));
  while (times.length < kSamples && performance.now() - begin < kLongest);
  times.sort((a, b) => a - b);
  return times[times.length >> 1];
}

/** At how many pixels another polygon is seen than in the truth. */
function wrong_pixels(ids, truth) {
  let wrong = 0;
  for (let k = 0; k < ids.length; ++k) wrong += ids[k] !== truth[k];
  return wrong;
}

/** Draws with the options: times anew, in views that follow each other as while turning, where there
 *  are any; times again; and wrong pixels of `truth` in the view that is shown. */
function measured(scene, view, options, views, truth) {
  const again = median_time(() => scene.picture(view, options));
  let next = 0;
  const draw_next = () => scene.picture(views[next++ % views.length], options);
  const anew = views.length > 0 ? median_time(draw_next) : undefined;
  const { ids } = scene.picture(view, { ...options, ids: true });
  return { again, anew, wrong: ids && wrong_pixels(ids, truth) };
}
