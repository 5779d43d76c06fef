/* continue without a loop; a switch is none. */
int main(int argc, char **argv)
{
    switch (argc) {
    case 1: continue; // error: continue
    }
    return 0;
}
