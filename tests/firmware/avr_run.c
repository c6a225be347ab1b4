/* avr_run FIRMWARE WORDS: runs the firmware in simavr, writes its words to a
 * file and prints the bytes of its state and the most cycles of a call for
 * lines and for arcs. */
#include <simavr/avr_ioport.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { GPIOR0 = 0x3e, GPIOR1 = 0x4a, GPIOR2 = 0x4b };

static FILE* words;
static avr_cycle_count_t begin, taken, most[3], sum[3], count[3];
static int bytes, last;

static void write0(avr_t* avr, avr_io_addr_t addr, uint8_t v, void* param) {
  (void)addr;
  (void)param;
  taken = avr->cycle - begin;
  last = v;
  if (v < 0xfd) fputc(v, words);
}
/* 1 before a call; the kind of the record after it. */
static void write1(avr_t* avr, avr_io_addr_t addr, uint8_t v, void* param) {
  static int before = 1;
  (void)addr;
  (void)param;
  if (before) {
    begin = avr->cycle;
  } else if (last < 0xfd && v < 3) {
    if (taken > most[v]) most[v] = taken;
    sum[v] += taken;
    ++count[v];
  }
  before = !before;
}
static void write2(avr_t* avr, avr_io_addr_t addr, uint8_t v, void* param) {
  (void)avr;
  (void)addr;
  (void)param;
  bytes = v;
}

int main(int argc, char** argv) {
  elf_firmware_t firmware;
  avr_t* avr;
  int state = cpu_Running;
  if (argc != 3) return 2;
  memset(&firmware, 0, sizeof firmware);
  if (elf_read_firmware(argv[1], &firmware) != 0) return 3;
  avr = avr_make_mcu_by_name("atmega328p");
  words = fopen(argv[2], "wb");
  if (avr == NULL || words == NULL) return 3;
  avr_init(avr);
  firmware.frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  avr_register_io_write(avr, GPIOR0, write0, NULL);
  avr_register_io_write(avr, GPIOR1, write1, NULL);
  avr_register_io_write(avr, GPIOR2, write2, NULL);
  while (state != cpu_Done && state != cpu_Crashed && avr->cycle < 400000000) {
    state = avr_run(avr);
  }
  fclose(words);
  printf("state %d line %d mean %d arc %d mean %d end %d\n", bytes,
         (int)most[1], (int)(sum[1] / (count[1] + !count[1])), (int)most[2],
         (int)(sum[2] / (count[2] + !count[2])), last);
  return 0;
}
