/** The library that draws plots, with its styles. Loaded when there is something to plot. */
import 'uplot/dist/uPlot.min.css';

export { default } from 'uplot';
