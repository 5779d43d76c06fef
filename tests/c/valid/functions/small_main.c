/* A main so small that it can be inlined in what calls it, with an access that is checked. */
int cells[4] = { 6, 7, 8, 9 };

int main(int argc, char **argv)
{
    return cells[argc] != 7 || !argv[0];
}
