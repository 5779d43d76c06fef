/* Pointers converted to integers and back, and between object types. */
#include <stdio.h>
#include <stdint.h>

struct header {
    int kind;
    int size;
};

struct message {
    struct header head;
    char body[8];
};

int main(void)
{
    int numbers[4] = { 1, 2, 3, 4 };
    uintptr_t address = (uintptr_t) numbers;
    int *p = (int *) (address + 2 * sizeof(int));
    unsigned word = 0x04030201;
    unsigned char *bytes = (unsigned char *) &word;
    struct message m = { { 3, 5 }, "hello" };
    struct header *head = (struct header *) &m;
    void *anything = &m;
    char *raw = anything;

    printf("%d\n", *p);
    printf("%d\n", (int) ((uintptr_t) &numbers[3] - address));
    printf("%d %d %d %d\n", bytes[0], bytes[1], bytes[2], bytes[3]);
    printf("%d %d %s\n", head->kind, head->size, ((struct message *) head)->body);
    printf("%c\n", raw[sizeof(struct header) + 1]);
    printf("%d %d\n", (void *) 0 == NULL, (int) (uintptr_t) (char *) 1234);
    printf("%d\n", address % sizeof(int) == 0);
    anything = p;
    printf("%d\n", *(int *) anything);
    printf("%d\n", (int *) anything - numbers);
    return 0;
}
