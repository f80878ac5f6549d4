// Speed and wrong pixels of one method on a scene, in the worker.
'use strict';

/** How long the call takes, in milliseconds: the median of some calls, more of them if it is fast. */
function median_time(call) {
  const kLeast = 3, kMost = 25, kEnough = 400;
  const times = [];
  for (let all = 0; times.length < kLeast || (times.length < kMost && all < kEnough);) {
    const begin = performance.now();
    call(times.length);
    times.push(performance.now() - begin);
    all += times.at(-1);
  }
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
  const anew = views.length > 0 ? median_time((k) => scene.picture(views[k % views.length], options)) : undefined;
  const { ids } = scene.picture(view, { ...options, ids: true });
  return { again, anew, wrong: ids && wrong_pixels(ids, truth) };
}
