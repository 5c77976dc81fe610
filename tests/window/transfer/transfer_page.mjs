// Transfer tab in a browser, for the labs of tests/installer/transfer_test.sh.
import {kNothingRuns} from '../../../window/page/src/messages.js';

export async function openTransfer(browser, url) {
  const page = await browser.newPage({viewport: {width: 1366, height: 1000}, bypassCSP: true});  // for axe only
  await page.goto(url);
  await page.getByRole('tab', {name: 'Transfer'}).click();
  await page.getByText(kNothingRuns).waitFor();
  return page;
}

/// Waits for a console line; reports result or progress on failure.
export const line = (page, kind, text) => page.locator(`#transfer-console .${kind}`, {hasText: text}).first().waitFor();
export const becomes = (page, how) => page.locator('#transfer-state', {hasText: how}).waitFor();
