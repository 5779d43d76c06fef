/* main alone, with two parameters: as small as a function that is inlined. */
int cells[10];

int main(int argc, char **argv)
{
    return cells[argc + 9];  // error: out of bounds
}
