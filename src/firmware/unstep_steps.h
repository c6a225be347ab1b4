/* Step pulses from a device profile (docs/format.md, "Device profile"), for
 * microcontrollers: C99 or C++, integers only, no heap, at most 72 bytes of
 * state. A call makes one step in bounded time.
 *
 *     unstep_steps s;
 *     unstep_steps_begin(&s, payload, size);
 *     for (;;) {
 *       uint8_t word = unstep_steps_next(&s);
 *       if (word >= UNSTEP_STEPS_MORE) break;
 *       pulse(word);
 *     }
 *
 * A word has bit 0 for a step in x, bit 1 if it goes back, bits 2 and 3 the
 * same of y, and bit 4 in rapids. Lines are those of Method::evaluation8, arcs
 * those of Method::circular with diagonal steps: the same steps as
 * `unstep steps` makes.
 *
 * The payload may come in pieces: UNSTEP_STEPS_MORE says that no whole record
 * is left; unstep_steps_more with the rest and what follows it goes on, for
 * nothing of a record is consumed before all of it is there. With
 * UNSTEP_STEPS_FLASH defined the payload is read from program memory (AVR).
 */
#ifndef UNSTEP_STEPS_H
#define UNSTEP_STEPS_H

#include <stdint.h>
#include <string.h>

#if defined(UNSTEP_STEPS_FLASH)
#include <avr/pgmspace.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum {
  UNSTEP_STEPS_MORE = 0xfd, /* no whole record is left */
  UNSTEP_STEPS_BAD = 0xfe,  /* the payload is damaged; stays so */
  UNSTEP_STEPS_END = 0xff   /* the end record was reached; stays so */
};

typedef struct {
  const uint8_t* next;
  const uint8_t* end;
  uint8_t kind;      /* of the record at work: 0 none, 1 line, 2 arc */
  uint8_t last;      /* UNSTEP_STEPS_BAD or _END once it was met, else 0 */
  uint8_t rapid;     /* 0x10 in rapids */
  uint8_t straight;  /* line: word of a step along its longer axis */
  uint8_t diagonal;  /* line: word of a step along both */
  uint8_t crossings; /* arc: axes still to cross */
  uint8_t turns;     /* arc: quarter turns from the plane to the frame */
  uint8_t mirrored;  /* arc: x and y are exchanged */
  uint8_t walked;    /* arc: only the way to its end remains */
  uint8_t word_a;    /* arc: word of a step along a */
  uint8_t word_b;    /* arc: along b */
  int16_t n;         /* line: steps left */
  int16_t most;      /* line: its larger part; arc: radius on the axes */
  int16_t least;     /* line: its smaller part */
  int16_t rest;      /* line: remainder */
  int16_t a, b;      /* arc: place in the frame; a grows, b shrinks */
  int16_t to_a, to_b;
  int16_t end_a, end_b;
  uint32_t f; /* arc: a^2 + b^2 - R^2, two's complement */
} unstep_steps;

static inline uint8_t unstep_steps_byte(const uint8_t* at) {
#if defined(UNSTEP_STEPS_FLASH)
  return pgm_read_byte(at);
#else
  return *at;
#endif
}

/* The first piece of a payload, or the next one after UNSTEP_STEPS_MORE. */
static inline void unstep_steps_more(unstep_steps* s, const uint8_t* payload,
                                     uint32_t size) {
  s->next = payload;
  s->end = payload + size;
}

static inline void unstep_steps_begin(unstep_steps* s, const uint8_t* payload,
                                      uint32_t size) {
  memset(s, 0, sizeof *s);
  unstep_steps_more(s, payload, size);
}

/* A number of one byte, or of two, the lower first. */
static inline int16_t unstep_steps_number(const uint8_t* at, uint8_t wide) {
  const uint8_t low = unstep_steps_byte(at);
  if (!wide) return (int8_t)low;
  return (int16_t)((uint16_t)unstep_steps_byte(at + 1) << 8 | low);
}

static inline void unstep_steps_line(unstep_steps* s, uint8_t wide) {
  const uint8_t* at = s->next;
  int16_t x = unstep_steps_number(at, wide);
  int16_t y = unstep_steps_number(at + 1 + wide, wide);
  uint8_t along_x = 1, along_y = 4;
  s->next = at + 2 + 2 * wide;
  if (x < 0) x = (int16_t)-x, along_x = 3;
  if (y < 0) y = (int16_t)-y, along_y = 12;
  s->diagonal = along_x | along_y;
  if (x >= y) {
    s->most = x;
    s->least = y;
    s->straight = along_x;
  } else {
    s->most = y;
    s->least = x;
    s->straight = along_y;
  }
  s->n = s->most;
  s->rest = s->most >> 1;
}

/* Words of the frame's steps in the plane: 0 to 3 quarter turns, then the
 * mirror. */
static inline void unstep_steps_words(unstep_steps* s) {
  /* Along a and back along b: the moves (1, 0) and (0, -1) turned. */
  switch (s->turns & 3) {
    case 0: s->word_a = 1, s->word_b = 12; break;
    case 1: s->word_a = 12, s->word_b = 3; break;
    case 2: s->word_a = 3, s->word_b = 4; break;
    default: s->word_a = 4, s->word_b = 1; break;
  }
  if (s->mirrored) {
    s->word_a = (uint8_t)((s->word_a >> 2 | s->word_a << 2) & 15);
    s->word_b = (uint8_t)((s->word_b >> 2 | s->word_b << 2) & 15);
  }
}

static inline void unstep_steps_target(unstep_steps* s) {
  if (s->crossings > 0) {
    s->to_a = s->most;
    s->to_b = 0;
  } else {
    s->to_a = s->a > s->end_a ? s->a : s->end_a;
    s->to_b = s->b < s->end_b ? s->b : s->end_b;
  }
}

static inline void unstep_steps_arc(unstep_steps* s, uint8_t head,
                                    uint8_t wide) {
  const uint8_t* at = s->next;
  const uint8_t size = (uint8_t)(1 + wide);
  s->mirrored = head & 32;
  s->turns = head >> 6;
  s->crossings = unstep_steps_byte(at++);
  s->a = unstep_steps_number(at, wide);
  s->b = unstep_steps_number(at += size, wide);
  s->most = unstep_steps_number(at += size, wide);
  s->end_a = unstep_steps_number(at += size, wide);
  s->end_b = unstep_steps_number(at += size, wide);
  s->next = at + size;
  s->f = 0;
  s->walked = 0;
  /* What no arc has, and what would never end. */
  if (s->crossings > 4 || s->most < 1 || s->a > s->most || s->a < 0 ||
      s->b < 1 || s->end_a < 0 || s->end_b < 0) {
    s->last = UNSTEP_STEPS_BAD;
    return;
  }
  unstep_steps_words(s);
  unstep_steps_target(s);
}

/* Reads the next record. 0, or what unstep_steps_next is to return. */
static inline uint8_t unstep_steps_record(unstep_steps* s) {
  uint8_t head, kind, wide, size;
  if (s->next == s->end) return UNSTEP_STEPS_MORE;
  head = unstep_steps_byte(s->next);
  if (head == 0) return s->last = UNSTEP_STEPS_END;
  kind = head & 3;
  wide = head & 8 ? 1 : 0;
  if ((kind == 1 ? head & 0xf0 : head & 0x10) != 0 || (kind & 1) == kind >> 1) {
    return s->last = UNSTEP_STEPS_BAD;
  }
  size = kind == 1 ? 3 : 7;
  if (wide) size = kind == 1 ? 5 : 12;
  if (s->end - s->next < size) return UNSTEP_STEPS_MORE;
  ++s->next;
  s->rapid = (uint8_t)((head & 4) << 2);
  if (kind == 1) {
    unstep_steps_line(s, wide);
  } else {
    unstep_steps_arc(s, head, wide);
  }
  s->kind = kind;
  return s->last;
}

/* To an end that is not on the circle; 0 once there. */
static inline uint8_t unstep_steps_correct(unstep_steps* s) {
  uint8_t word = 0;
  /* Backwards is the other bit of an axis that steps. */
  if (s->a < s->end_a) ++s->a, word = s->word_a;
  if (s->a > s->end_a)
    --s->a, word = (uint8_t)(s->word_a ^ (s->word_a & 5) << 1);
  if (s->b > s->end_b) --s->b, word |= s->word_b;
  if (s->b < s->end_b)
    ++s->b, word |= (uint8_t)(s->word_b ^ (s->word_b & 5) << 1);
  return word;
}

/* The larger of v and -v, two's complement. */
static inline uint32_t unstep_steps_size(uint32_t v) {
  return (int32_t)v < 0 ? 0 - v : v;
}

static inline uint8_t unstep_steps_next_arc(unstep_steps* s) {
  uint32_t fa, fb, fab, only_a, only_b, both;
  uint8_t step_a, step_b;
  while (!s->walked && s->a == s->to_a && s->b == s->to_b) {
    if (s->crossings == 0) {
      s->walked = 1;
      break;
    }
    --s->crossings;
    ++s->turns;
    s->b = s->a;
    s->a = 0;
    unstep_steps_words(s);
    unstep_steps_target(s);
  }
  if (s->walked) return unstep_steps_correct(s);
  fa = s->f + (uint32_t)((uint16_t)s->a << 1 | 1);
  fb = s->f - (uint32_t)((uint16_t)s->b << 1) + 1;
  fab = fa + fb - s->f;
  only_a = unstep_steps_size(fa);
  only_b = unstep_steps_size(fb);
  both = unstep_steps_size(fab);
  step_a = only_a <= only_b || both <= only_b;
  step_b = only_b < only_a || both <= only_a;
  if (s->a == s->to_a) step_a = 0, step_b = 1;
  if (s->b == s->to_b) step_b = 0, step_a = 1;
  s->f = step_a ? (step_b ? fab : fa) : fb;
  if (!step_a) {
    --s->b;
    return s->word_b;
  }
  ++s->a;
  if (!step_b) return s->word_a;
  --s->b;
  return s->word_a | s->word_b;
}

static inline uint8_t unstep_steps_next_line(unstep_steps* s) {
  if (s->n == 0) return 0;
  --s->n;
  s->rest = (int16_t)(s->rest - s->least);
  if (s->rest >= 0) return s->straight;
  s->rest = (int16_t)(s->rest + s->most);
  return s->diagonal;
}

/* The next step's word, or UNSTEP_STEPS_MORE, _BAD or _END. A record without
 * steps is passed over; the encoder writes none, so that a call reads at most
 * one record. */
static inline uint8_t unstep_steps_next(unstep_steps* s) {
  for (;;) {
    uint8_t word = 0;
    if (s->last != 0) return s->last;
    if (s->kind == 1) word = unstep_steps_next_line(s);
    if (s->kind == 2) word = unstep_steps_next_arc(s);
    if (word != 0) return word | s->rapid;
    s->kind = 0;
    word = unstep_steps_record(s);
    if (word != 0) return word;
  }
}

#ifdef __cplusplus
}
#endif

#endif
