// The tab Transfer in a browser, as the labs of tests/installer/transfer_test.sh look at it.

export async function openTransfer(browser, url) {
  const page = await browser.newPage({viewport: {width: 1366, height: 1000}, bypassCSP: true});  // for axe alone
  await page.goto(url);
  await page.getByRole('tab', {name: 'Transfer'}).click();
  await page.getByText('Nothing runs.').waitFor();
  return page;
}

/// A line of the console comes; the page tells how it ended, or how far it is.
export const line = (page, kind, text) => page.locator(`#transfer-console .${kind}`, {hasText: text}).first().waitFor();
export const becomes = (page, how) => page.locator('#transfer-state', {hasText: how}).waitFor();
