// JavaScript's BigInt for the truth's whole numbers (interp/truth/integer_bigint.h): each stands in a
// table, under a number that the compiled program has. This emscripten loses what is taken apart by
// `const { a, b } = c`.
mergeInto(LibraryManager.library, {
  $displayfileNumbers: { all: [null], free: [] },

  displayfile_bigint_of__deps: ['$displayfileNumbers'],
  displayfile_bigint_of: function (whole) {
    const all = displayfileNumbers.all;
    const free = displayfileNumbers.free;
    const place = free.length > 0 ? free.pop() : all.length;
    all[place] = BigInt(whole);
    return place;
  },
  displayfile_bigint_copy__deps: ['$displayfileNumbers'],
  displayfile_bigint_copy: function (n) {
    const all = displayfileNumbers.all;
    const free = displayfileNumbers.free;
    const place = free.length > 0 ? free.pop() : all.length;
    all[place] = all[n];
    return place;
  },
  displayfile_bigint_let_go__deps: ['$displayfileNumbers'],
  displayfile_bigint_let_go: function (n) {
    displayfileNumbers.all[n] = null;
    displayfileNumbers.free.push(n);
  },
  displayfile_bigint_set__deps: ['$displayfileNumbers'],
  displayfile_bigint_set: function (to, n) {
    displayfileNumbers.all[to] = displayfileNumbers.all[n];
  },
  displayfile_bigint_negate__deps: ['$displayfileNumbers'],
  displayfile_bigint_negate: function (to, n) {
    displayfileNumbers.all[to] = -displayfileNumbers.all[n];
  },
  displayfile_bigint_add__deps: ['$displayfileNumbers'],
  displayfile_bigint_add: function (to, a, b) {
    displayfileNumbers.all[to] = displayfileNumbers.all[a] + displayfileNumbers.all[b];
  },
  displayfile_bigint_subtract__deps: ['$displayfileNumbers'],
  displayfile_bigint_subtract: function (to, a, b) {
    displayfileNumbers.all[to] = displayfileNumbers.all[a] - displayfileNumbers.all[b];
  },
  displayfile_bigint_multiply__deps: ['$displayfileNumbers'],
  displayfile_bigint_multiply: function (to, a, b) {
    displayfileNumbers.all[to] = displayfileNumbers.all[a] * displayfileNumbers.all[b];
  },
  displayfile_bigint_divide__deps: ['$displayfileNumbers'],
  displayfile_bigint_divide: function (a, b, quotient, rest) {
    const all = displayfileNumbers.all;
    const dividend = all[a];
    const divisor = all[b];
    all[quotient] = dividend / divisor;
    all[rest] = dividend % divisor;
  },
  displayfile_bigint_shift_left__deps: ['$displayfileNumbers'],
  displayfile_bigint_shift_left: function (to, n, places) {
    displayfileNumbers.all[to] = displayfileNumbers.all[n] << BigInt(places);
  },
  displayfile_bigint_shift_right__deps: ['$displayfileNumbers'],
  displayfile_bigint_shift_right: function (to, n, places) {
    displayfileNumbers.all[to] = displayfileNumbers.all[n] >> BigInt(places);
  },
  displayfile_bigint_compare__deps: ['$displayfileNumbers'],
  displayfile_bigint_compare: function (a, b) {
    const all = displayfileNumbers.all;
    return all[a] < all[b] ? -1 : all[a] > all[b] ? 1 : 0;
  },
  displayfile_bigint_sign__deps: ['$displayfileNumbers'],
  displayfile_bigint_sign: function (n) {
    const number = displayfileNumbers.all[n];
    return number < 0 ? -1 : number > 0 ? 1 : 0;
  },
  displayfile_bigint_digits__deps: ['$displayfileNumbers'],
  displayfile_bigint_digits: function (n) {
    const number = displayfileNumbers.all[n];
    const digits = (number < 0 ? -number : number).toString(16);
    return 4 * digits.length - Math.clz32(parseInt(digits[0], 16)) + 28;
  },
  displayfile_bigint_zeros__deps: ['$displayfileNumbers'],
  displayfile_bigint_zeros: function (n) {
    const number = displayfileNumbers.all[n];
    return (number & -number).toString(2).length - 1;  // of its last binary digit that is 1
  },
  displayfile_bigint_magnitude__deps: ['$displayfileNumbers'],
  displayfile_bigint_magnitude: function (n, low, high) {
    const number = displayfileNumbers.all[n];
    const size = number < 0 ? -number : number;
    HEAPU32[low >> 2] = Number(BigInt.asUintN(32, size));
    HEAPU32[high >> 2] = Number(BigInt.asUintN(32, size >> BigInt(32)));
  },
});
