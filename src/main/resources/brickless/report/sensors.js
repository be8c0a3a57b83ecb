// What sensors' values mean: quantity, unit and words, by the device's mode, or by its kind if it has but one.

/** A number with a unit, in some `sense` or of a scale; `of` makes it from what the device sends, NaN for nothing, which `lack` names. */
function quantity(what, unit, places = 0, of = (value) => value, lack = '–') {
  return {what, unit, places, of, lack};
}

/** One of a few states. State 0 is not painted; `paints` are CSS colours of the others. */
function states(what, words, paints = []) {
  return {what, unit: '', words, paints, places: 0, of: (value) => value, lack: '–'};
}

function echo(nothing, centimetres) {
  return quantity('distance', 'cm', 1, (value) => (value >= nothing ? NaN : value * centimetres), 'no echo');
}

function each(channels, quantities) {
  return channels.flatMap((name) => quantities.map((one) => ({...one, name})));
}

const CHANNELS = ['channel 1', 'channel 2', 'channel 3', 'channel 4'];
const COLOUR = states('colour', ['none', 'black', 'blue', 'green', 'yellow', 'red', 'white', 'brown'],
  ['', '#22252a', '#1f5fd6', '#2e8b3d', '#f2c81b', '#d02c20', '#ffffff', '#8a5a2b']);
const REMOTE = states('remote', ['no button', 'top left', 'bottom left', 'top right', 'bottom right', 'both top', 'top left, bottom right',
  'bottom left, top right', 'both bottom', 'beacon', 'both left', 'both right']);
const TOUCH = states('', ['released', 'pressed']);
const ANGLE = {...quantity('angle', '°'), sense: 'clockwise'};
const RATE = {...quantity('rate', '°/s'), sense: 'clockwise'};
const LIGHT_PARTS = [['red', '#d02c20'], ['green', '#2e8b3d'], ['blue', '#3f7cf0']]
  .map(([name, colour]) => ({...{...quantity('light parts', ''), sense: 'of 1020'}, name, colour}));

const SENSOR_QUANTITIES = {
  'US-DIST-CM': [echo(2550, 0.1)],
  'US-SI-CM': [echo(2550, 0.1)],
  'US-DC-CM': [echo(2550, 0.1)],
  'US-DIST-IN': [echo(1003, 0.254)],
  'US-SI-IN': [echo(1003, 0.254)],
  'US-DC-IN': [echo(1003, 0.254)],
  'US-LISTEN': [states('another one', ['not heard', 'heard'])],
  'GYRO-ANG': [ANGLE],
  'GYRO-RATE': [RATE],
  'GYRO-FAS': [RATE],
  'GYRO-G&A': [ANGLE, RATE],
  'COL-REFLECT': [quantity('reflected light', '%')],
  'COL-AMBIENT': [quantity('ambient light', '%')],
  'COL-COLOR': [COLOUR],
  'RGB-RAW': LIGHT_PARTS,
  'IR-PROX': [{...quantity('proximity', ''), sense: 'of 100'}],
  'IR-SEEK': each(CHANNELS, [{...quantity('bearing', ''), sense: '−25 to 25'},
    {...quantity('distance', '', 0, (value) => (value < 0 ? NaN : value)), sense: 'of 100'}]),
  'IR-REMOTE': each(CHANNELS, [REMOTE]),
  'ev3-touch': [TOUCH],
  'nxt-touch': [TOUCH],
  'nxt-light': [quantity('light', '%', 0, (value) => value * 100)],
  'nxt-sound': [quantity('sound', '%', 0, (value) => value * 100)],
  'nxt-color': [COLOUR],
  'nxt-ultrasonic': [echo(255, 1)],
};

/** What a value of a sensor is; plain numbers where the mode is not known. */
function sensorQuantity(kind, mode, index) {
  const known = SENSOR_QUANTITIES[mode] || SENSOR_QUANTITIES[kind] || [];
  return known[index] || {...quantity('as sent', '', 1), name: String(index)};
}

/** The modes that a sensor was in, as the trace's events tell: {t, mode} in order of time. */
function sensorModes(events, port, kind) {
  return events.filter((event) => event.type === 'mode' && event.port === port && event.kind === kind);
}

function modeAt(sensor, time) {
  const {modes} = sensor;
  const i = Math.max(0, lastNotAfter(modes, time + 1e-9, (one) => one.t));
  return modes.length > 0 ? modes[i].mode : '';
}

function quantityText(one, value) {
  if (Number.isNaN(value)) {
    return one.lack;
  }
  return one.words ? one.words[value] || String(value) : `${number(value, one.places)}${one.unit && one.unit !== '°' ? ' ' : ''}${one.unit}`;
}

/** What a sensor says at a sample, in words; empty while it says nothing. */
function sensorText(sensor, sample, time) {
  const mode = modeAt(sensor, time);
  const said = sensor.values.map((values, i) => ({one: sensorQuantity(sensor.kind, mode, i), value: values[sample]})).filter(({value}) => !Number.isNaN(value));
  const busy = said.filter(({one, value}) => !one.name || (one.words ? value > 0 : !Number.isNaN(one.of(value))));
  return (busy.length > 0 ? busy : said.slice(0, 1)).slice(0, 3).map(({one, value}) => quantityText(one, one.of(value))).join(' ');
}

function sensorTitle(sensor) {
  return `S${sensor.port} ${sensorName(sensor.kind)}`;
}

/** The plots of a sensor: one for each quantity that it measured, with a value where it was in the mode for it. */
function sensorPlots(sensor, times) {
  const plots = new Map();
  const spans = sensor.modes.length > 0 ? sensor.modes : [{t: 0, mode: ''}];
  spans.forEach(({t, mode}, span) => {
    const from = span === 0 ? 0 : lastNotAfter(times, t - 1e-9) + 1;
    const to = span + 1 < spans.length ? lastNotAfter(times, spans[span + 1].t - 1e-9) : times.length - 1;
    sensor.values.forEach((values, i) => copyQuantity(plots, sensor, sensorQuantity(sensor.kind, mode, i), values, from, to));
  });
  return [...plots.values()];
}

function copyQuantity(plots, sensor, one, values, from, to) {
  let series = null;
  for (let i = from; i <= to; i++) {
    if (!Number.isNaN(values[i])) {
      series = series || seriesOf(plots, sensor, one, values.length);
      series.values[i] = one.of(values[i]);
    }
  }
}

function seriesOf(plots, sensor, one, length) {
  const id = `s${sensor.port}-${sensor.kind}${one.what ? `-${one.what}` : ''}`;
  if (!plots.has(id)) {
    plots.set(id, {id, title: sensorTitle(sensor), what: one.what, unit: one.unit, sense: one.sense, places: one.places, lack: one.lack,
      words: one.words, paints: one.paints, series: [], on: true});
  }
  const plot = plots.get(id);
  const name = one.name || '';
  let series = plot.series.find((other) => other.name === name);
  if (!series) {
    series = {name, colour: one.colour || `var(--series-${plot.series.length % 4})`, values: new Float64Array(length).fill(NaN)};
    plot.series.push(series);
  }
  return series;
}
