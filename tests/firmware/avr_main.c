/* Draws the profile on an ATmega328P. The simulator sees the kind of each
 * record's step in GPIOR1 just before a call and its word in GPIOR0 just after.
 */
#define UNSTEP_STEPS_FLASH
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "profile.h"
#include "src/firmware/unstep_steps.h"

static unstep_steps s;

int main(void) {
  unstep_steps_begin(&s, profile, sizeof profile);
  GPIOR2 = sizeof s;
  for (;;) {
    uint8_t word;
    GPIOR1 = 1;
    word = unstep_steps_next(&s);
    GPIOR0 = word;
    GPIOR1 = s.kind;
    if (word >= UNSTEP_STEPS_MORE) break;
  }
  cli();
  sleep_enable();
  sleep_cpu();
  return 0;
}
