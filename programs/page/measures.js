// How long drawing takes, and at how many pixels it is wrong, in the worker.
'use strict';

/** How long a call takes, in milliseconds: the mean of as many calls as take `least` together, since a
 *  browser's clock may go in tenths of a millisecond. */
function mean_time(call, least) {
  const begin = performance.now();
  for (let made = 1;; ++made) {
    call();
    const passed = performance.now() - begin;
    if (passed >= least) return passed / made;
  }
}

/** The picture again; and anew, in views that follow each other as while turning, where there are any. */
function drawing_times(scene, view, options, views, least) {
  const again = mean_time(() => scene.picture(view, options), least);
  if (views.length === 0) return { again };
  let next = 0;
  return { again, anew: mean_time(() => scene.picture(views[next++ % views.length], options), least) };
}

/** The number of pixels at which another polygon is seen than in the truth. */
function wrong_pixels(ids, truth) {
  let wrong = 0;
  for (let k = 0; k < ids.length; ++k) wrong += ids[k] !== truth[k];
  return wrong;
}
